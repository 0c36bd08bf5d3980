// What lies beside a plan's image and is no regular file. Who opens a pipe waits for ever.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/site/plan.h"
#include "tests/core/site/made_images.h"
#include "tests/core/text/scratch_folder.h"

namespace hedr {
namespace {

namespace fs = std::filesystem;

class PlanCompanions : public testing::Test {
  protected:
    fs::path at(const std::string& name) const { return folder_.path() / name; }
    fs::path make(const std::string& name, const std::string& driver) const {
        ImageMaking making{.driver = driver};
        if (driver == "MBTiles") {
            making.affine = {1e6, 1, 0, 6e6, 0, -1};
            making.system = "EPSG:3857";
        }
        makeImage(at(name), markedPaper(60, 40, driver == "GIF" ? 1 : 4), making);
        return at(name);
    }
    void pipe(const std::string& name) const { ASSERT_EQ(mkfifo(at(name).c_str(), 0600), 0); }

  private:
    ScratchFolder folder_;
};

// What loading says, empty if all is well; a thread that hangs is left behind with its own copies.
std::string outcomeOf(const fs::path& file) {
    auto promise = std::make_shared<std::promise<std::string>>();
    auto outcome = promise->get_future();
    std::thread([file, promise] {
        const auto plan = loadPlan(file);
        promise->set_value(plan ? std::string() : plan.error().detail);
    }).detach();
    if (outcome.wait_for(std::chrono::seconds(5)) == std::future_status::ready) {
        return outcome.get();
    }
    return "hangs";
}

TEST_F(PlanCompanions, APipeNamedLikeACompanionIsPassedOver) {
    make("plan.png", "PNG");
    make("plan.jpg", "JPEG");
    make("plan.gif", "GIF");
    const std::vector<std::string> companions = {
        "plan.pgw",         "plan.wld", "plan.gfw",         "plan.jgw", "plan.png.aux.xml",
        "plan.jpg.aux.xml", "plan.ovr", "plan.gif.aux.xml", "plan.aux", "plan.png.ovr",
        "plan.gif.ovr",     "plan.tab", "plan.png.msk",     "PLAN.WLD"};
    for (const std::string& companion : companions) pipe(companion);
    for (const char* name : {"plan.png", "plan.jpg", "plan.gif"}) {
        EXPECT_EQ(outcomeOf(at(name)), "") << name;
    }
}

// These formats' readers open what they guess.
TEST_F(PlanCompanions, WhereThePipeWouldBeOpenedTheImageIsRefused) {
    make("plan.bmp", "BMP");
    make("sheet.pdf", "PDF");
    make("site.mbtiles", "MBTiles");
    make("map.tif", "GTiff");
    for (const char* name : {"plan.bmp", "sheet.pdf", "site.mbtiles", "map.tif"})
        EXPECT_EQ(outcomeOf(at(name)), "") << name;
    pipe("plan.wld");
    pipe("sheet.pdf.ovr");
    pipe("map.tfw");
    pipe("site.mbtiles-journal");
    const std::string why = " beside it away: it is not a regular file";
    EXPECT_EQ(outcomeOf(at("plan.bmp")), "move plan.wld" + why);
    EXPECT_EQ(outcomeOf(at("sheet.pdf")), "move sheet.pdf.ovr" + why);
    EXPECT_EQ(outcomeOf(at("map.tif")), "move map.tfw" + why);
    EXPECT_EQ(outcomeOf(at("site.mbtiles")), "move site.mbtiles-journal" + why);
}

TEST_F(PlanCompanions, APipeNamedLikeAPlacementIsNotRead) {
    make("plan.png", "PNG");
    pipe("plan.toml");
    pipe("plan.yaml");
    EXPECT_EQ(outcomeOf(at("plan.png")), "");
    EXPECT_EQ(outcomeOf(at("plan.yaml")), "not a regular file");
}

// A list of what may be opened must not hide what is meant.
TEST_F(PlanCompanions, AWorldFileInOtherLettersIsStillFound) {
    make("plan.png", "PNG");
    writeBytes(at("PLAN.PGW"), "0.5\n0\n0\n-0.5\n10\n20\n");
    const auto plan = loadPlan(at("plan.png"));
    ASSERT_TRUE(plan);
    EXPECT_DOUBLE_EQ(plan->placement.resolution_m, 0.5);
}

}  // namespace
}  // namespace hedr
