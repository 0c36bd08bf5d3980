#include "core/site/raster/written_raster.h"

#include <cpl_conv.h>

#include <array>
#include <string>

namespace hedr {

Dataset bandsOn(const PlanLevel& image) {
    GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    Dataset dataset(memory
                        ? memory->Create("", image.width_px, image.height_px, 0, GDT_Byte, nullptr)
                        : nullptr);
    if (!dataset) return dataset;
    const int bands = image.channels == 1 ? 1 : 3;
    for (int band = 0; band < bands; ++band) {
        const std::uint8_t* first = image.pixels->data() + (bands - 1 - band);
        std::array<char, 64> pointer{};
        // GDAL only reads them.
        CPLPrintPointer(pointer.data(), const_cast<std::uint8_t*>(first), pointer.size() - 1);
        GdalWords options({std::string("DATAPOINTER=") + pointer.data(),
                           "PIXELOFFSET=" + std::to_string(image.channels),
                           "LINEOFFSET=" + std::to_string(image.channels * image.width_px)});
        if (dataset->AddBand(GDT_Byte, options.get()) != CE_None) return nullptr;
        dataset->GetRasterBand(band + 1)->SetColorInterpretation(
            bands == 1 ? GCI_GrayIndex : static_cast<GDALColorInterp>(GCI_RedBand + band));
    }
    return dataset;
}

int CPL_STDCALL WrittenShare::ask(double share, const char*, void* written_share) {
    auto& written = *static_cast<WrittenShare*>(written_share);
    if (written.progress_ && !written.progress_(share)) written.canceled_ = true;
    return written.canceled_ ? FALSE : TRUE;
}

}  // namespace hedr
