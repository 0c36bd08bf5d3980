#include "tests/core/site/made_images.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <fstream>
#include <iterator>

namespace hedr {
namespace {

GDALColorInterp meaningOf(const std::string& name) {
    for (int i = GCI_Undefined; i <= GCI_Max; ++i) {
        const auto meaning = static_cast<GDALColorInterp>(i);
        if (name == GDALGetColorInterpretationName(meaning)) return meaning;
    }
    return GCI_Undefined;
}

}  // namespace

void makeImage(const std::filesystem::path& file, const PlanLevel& pixels,
               const ImageMaking& making) {
    GDALAllRegister();
    const int bands = pixels.channels == 1 ? 1 : (making.alpha ? 4 : 3);
    auto* memory = GetGDALDriverManager()->GetDriverByName("MEM");
    GDALDatasetUniquePtr picture(
        memory->Create("", pixels.width_px, pixels.height_px, bands, GDT_Byte, nullptr));
    std::array<int, 4> order = {3, 2, 1, 4};
    if (bands == 1) order[0] = 1;
    ASSERT_EQ(
        picture->RasterIO(GF_Write, 0, 0, pixels.width_px, pixels.height_px,
                          const_cast<std::uint8_t*>(pixels.pixels->data()), pixels.width_px,
                          pixels.height_px, GDT_Byte, bands, order.data(), pixels.channels,
                          static_cast<GSpacing>(pixels.channels) * pixels.width_px, 1, nullptr),
        CE_None);
    constexpr std::array kColours = {GCI_RedBand, GCI_GreenBand, GCI_BlueBand, GCI_AlphaBand};
    for (int i = 0; bands > 1 && i < bands; ++i) {
        const auto at = static_cast<std::size_t>(i);
        picture->GetRasterBand(i + 1)->SetColorInterpretation(
            making.band_meanings.empty() ? kColours[at] : meaningOf(making.band_meanings[at]));
    }
    if (making.affine) {
        auto affine = *making.affine;
        picture->SetGeoTransform(affine.data());
    }
    if (!making.system.empty()) {
        OGRSpatialReference system;
        system.SetFromUserInput(making.system.c_str());
        picture->SetSpatialRef(&system);
    }
    std::vector<std::string> words = making.options;
    std::vector<char*> options;
    for (std::string& word : words) options.push_back(word.data());
    options.push_back(nullptr);
    GDALDatasetUniquePtr written(
        GetGDALDriverManager()
            ->GetDriverByName(making.driver.c_str())
            ->CreateCopy(file.c_str(), picture.get(), FALSE, options.data(), nullptr, nullptr));
    ASSERT_TRUE(written) << file;
    if (!making.overviews.empty()) {
        auto factors = making.overviews;
        written->BuildOverviews("AVERAGE", static_cast<int>(factors.size()), factors.data(), 0,
                                nullptr, nullptr, nullptr);
    }
}

PlanLevel markedPaper(int width_px, int height_px, int channels) {
    const auto pixels = std::make_shared<std::vector<std::uint8_t>>(
        static_cast<std::size_t>(width_px * height_px * channels), std::uint8_t{255});
    for (int y = 0; y < height_px / 4; ++y) {
        for (int i = 0; i < width_px / 6 * channels; ++i) {
            if (channels == 4 && i % 4 == 3) continue;
            (*pixels)[static_cast<std::size_t>(y * width_px * channels + i)] = 0;
        }
    }
    return {width_px, height_px, channels, pixels};
}

std::string pdfText(const std::vector<std::array<int, 2>>& pages, const std::string& trailer) {
    std::vector<std::string> objects{"<< /Type /Catalog /Pages 2 0 R >>", ""};
    std::string kids;
    for (const auto& [width, height] : pages) {
        const auto number = [](std::size_t i) { return std::to_string(i) + " 0 R"; };
        kids += number(objects.size() + 1) + ' ';
        objects.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 " + std::to_string(width) +
                          ' ' + std::to_string(height) + "] /Contents " +
                          number(objects.size() + 2) + " >>");
        const std::string block = "0 g 0 " + std::to_string(height - height / 4) + ' ' +
                                  std::to_string(width / 6) + ' ' + std::to_string(height / 4) +
                                  " re f";
        objects.push_back("<< /Length " + std::to_string(block.size()) + " >>\nstream\n" + block +
                          "\nendstream");
    }
    objects[1] =
        "<< /Type /Pages /Kids [" + kids + "] /Count " + std::to_string(pages.size()) + " >>";
    std::string text = "%PDF-1.4\n";
    std::string table = "xref\n0 " + std::to_string(objects.size() + 1) + "\n0000000000 65535 f \n";
    for (std::size_t i = 0; i < objects.size(); ++i) {
        std::string offset = std::to_string(text.size());
        table += std::string(10 - offset.size(), '0') + offset + " 00000 n \n";
        text += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
    }
    const std::string start = std::to_string(text.size());
    return text + table + "trailer\n<< /Size " + std::to_string(objects.size() + 1) +
           " /Root 1 0 R " + trailer + " >>\nstartxref\n" + start + "\n%%EOF\n";
}

namespace {

void put(std::string& bytes, int value, int size) {
    for (int i = 0; i < size; ++i)
        bytes += static_cast<char>(static_cast<unsigned>(value) >> (8 * i) & 0xFFU);
}

// One row of a directory: tag, type, how many, the value or where it is.
void putRow(std::string& bytes, int tag, int type, int value) {
    put(bytes, tag, 2);
    put(bytes, type, 2);
    put(bytes, 1, 4);
    put(bytes, value, 4);
}

}  // namespace

std::string withExifOrientation(const std::string& jpeg, int orientation) {
    return withExif(jpeg, orientation, {});
}

std::string withExif(const std::string& jpeg, int orientation, const std::vector<ExifTag>& tags) {
    constexpr int kLong = 4;
    constexpr int kRational = 5;
    constexpr int kRow = 12;
    constexpr int kSecond = 8 + 2 + 2 * kRow + 4;  // where the second directory begins
    std::string tiff("II*\0\x08\0\0\0\x02\0", 10);
    putRow(tiff, 0x0112, 3, orientation);
    putRow(tiff, 0x8769, kLong, kSecond);
    put(tiff, 0, 4);
    std::string fractions;
    const int count = static_cast<int>(tags.size());
    put(tiff, count, 2);
    for (const ExifTag& tag : tags) {
        const int there = kSecond + 2 + kRow * count + 4 + static_cast<int>(fractions.size());
        const bool whole = tag.denominator == 0;
        putRow(tiff, tag.tag, whole ? kLong : kRational, whole ? tag.numerator : there);
        if (whole) continue;
        put(fractions, tag.numerator, 4);
        put(fractions, tag.denominator, 4);
    }
    put(tiff, 0, 4);
    const std::string exif = std::string("Exif\0\0", 6) + tiff + fractions;
    const auto length = exif.size() + 2;
    std::string segment = "\xFF\xE1";
    segment += static_cast<char>(length >> 8U);
    segment += static_cast<char>(length & 0xFFU);
    return jpeg.substr(0, 2) + segment + exif + jpeg.substr(2);
}

std::string bytesOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
}

void makeArchive(const std::filesystem::path& file,
                 const std::vector<std::pair<std::string, std::string>>& files) {
    const std::string archive = "/vsizip/" + file.string();
    VSILFILE* whole = VSIFOpenL(archive.c_str(), "wb");  // held open: one file after the other
    ASSERT_TRUE(whole);
    for (const auto& [name, bytes] : files) {
        VSILFILE* out = VSIFOpenL((archive + '/' + name).c_str(), "wb");
        ASSERT_TRUE(out) << name;
        EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), out), bytes.size());
        EXPECT_EQ(VSIFCloseL(out), 0);
    }
    EXPECT_EQ(VSIFCloseL(whole), 0);
}

}  // namespace hedr
