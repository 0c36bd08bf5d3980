// `hedr plan` as scripts see it.
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/geometry/angle.h"
#include "core/mission/mission_writer.h"
#include "core/site/plan.h"
#include "core/text/text_file.h"
#include "core/track/track_file.h"
#include "tests/core/site/survey/corridors.h"
#include "tests/e2e/tool_fixture.h"

namespace hedr {
namespace {

class HedrPlan : public ToolFixture {
  protected:
    void SetUp() override {
        QImage image(400, 300, QImage::Format_RGB32);
        image.fill(Qt::white);
        ASSERT_TRUE(image.save(path("a.png")));
        write("a.toml",
              "image = \"a.png\"\nresolution_m = 0.1\norigin_x_m = 5\norigin_y_m = -2\n"
              "rotation_deg = 30\n");
    }

    nlohmann::json json(const QStringList& arguments) const {
        const Outcome outcome =
            run(kHedrTool, QStringList{"plan"} + arguments + QStringList{"--json"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err.toStdString();
        return nlohmann::json::parse(outcome.out.toStdString());
    }
    std::string file(const QString& name) const { return path(name).toStdString(); }
};

TEST_F(HedrPlan, SaysWhatAnImageIsAndWhereItLies) {
    const auto info = json({"info", path("a.toml")});
    EXPECT_EQ(info.at("format"), "PNG");
    EXPECT_EQ(info.at("width_px"), 400);
    EXPECT_EQ(info.at("height_px"), 300);
    EXPECT_EQ(info.at("placement").at("origin_x_m"), 5.0);
    EXPECT_NEAR(info.at("placement").at("rotation_deg"), 30.0, 1e-9);
    EXPECT_TRUE(info.at("geo_tie").is_null());
    EXPECT_EQ(info.at("sha256").get<std::string>().size(), 64u);
    const Outcome text = run(kHedrTool, {"plan", "info", path("a.png")});
    EXPECT_TRUE(text.out.contains("size       400 x 300 pixels")) << text.out.toStdString();
}

// Columns and rows of a plan of 0.1 m per pixel whose lower left corner is the origin.
constexpr const char* kPoints =
    "plan_x_px,plan_y_px,world_x_m,world_y_m,name\n0,300,0,0,door\n400,300,40,0,stairs\n"
    "400,0,40,30,lift\n0,0,0,30,window\n200,150,20,15,pillar\n";

TEST_F(HedrPlan, AlignsByPointsAndWritesThePlace) {
    write("p.csv", kPoints);
    const auto fit = json({"align", path("a.png"), path("p.csv"), "--out", path("found.toml")});
    EXPECT_NEAR(fit.at("placement").at("resolution_m"), 0.1, 1e-12);
    EXPECT_NEAR(fit.at("rms_m"), 0.0, 1e-9);
    EXPECT_EQ(fit.at("residuals").size(), 5u);
    const auto plan = loadPlan(file("found.toml"));
    ASSERT_TRUE(plan) << plan.error().detail;
    EXPECT_NEAR(plan->placement.resolution_m, 0.1, 1e-12);
}

TEST_F(HedrPlan, NamesTheWorstPointAndSaysItInCentimetres) {
    write("p.csv", QByteArray(kPoints).replace("40,30,lift", "41,30,lift") +
                       "100,100,10,20,post\n300,50,30,25,pipe\n50,250,5,5,sink\n");
    const Outcome text = run(kHedrTool, {"plan", "align", path("a.png"), path("p.csv")});
    EXPECT_EQ(text.exit_code, 0) << text.err.toStdString();
    EXPECT_TRUE(text.out.contains("worst      lift: probably wrong")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains("residual   door  ")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains(" cm\n")) << text.out.toStdString();
}

TEST_F(HedrPlan, KeepsScaleAndRotationWhereToldTo) {
    write("p.csv", kPoints);
    const auto fit =
        json({"align", path("a.toml"), path("p.csv"), "--keep-scale", "--keep-rotation"});
    EXPECT_EQ(fit.at("placement").at("resolution_m"), 0.1);
    EXPECT_NEAR(fit.at("placement").at("rotation_deg"), 30.0, 1e-9);
    EXPECT_GT(fit.at("rms_m"), 1.0);
}

TEST_F(HedrPlan, AlignsByPlacesOnTheGlobe) {
    write("p.csv",
          "plan_x_px,plan_y_px,latitude_deg,longitude_deg,name\n0,300,48.0,11.0,a\n"
          "400,300,48.0,11.001,b\n400,0,48.0004,11.001,c\n");
    const auto fit = json({"align", path("a.png"), path("p.csv")});
    EXPECT_EQ(fit.at("geo_tie").at("latitude_deg"), 48.0);
    EXPECT_NEAR(fit.at("placement").at("resolution_m"), 74.6 / 400.0, 0.02);
    const auto tied = json({"align", path("a.png"), path("p.csv"), "--tie", "48,11,90"});
    EXPECT_NEAR(tied.at("placement").at("rotation_deg").get<double>() -
                    fit.at("placement").at("rotation_deg").get<double>(),
                90.0, 0.01);
}

// A robot's map: walls black, free 254.
QImage mapOf(const FreeSpace& space) {
    QImage map(space.width, space.height, QImage::Format_Grayscale8);
    for (int y = 0; y < space.height; ++y) {
        for (int x = 0; x < space.width; ++x) {
            const bool free = space.at({x + 0.5, y + 0.5}) == Cell::kFree;
            map.scanLine(y)[x] = free ? 254 : 0;
        }
    }
    return map;
}

// A drive through the plan site.png, which lies with its upper left corner at (3, -7), turned by
// 20 degrees, and has `corridors`.
class HedrPlanByTrail : public HedrPlan {
  protected:
    static constexpr double kTurn_deg = 20.0;

    void saveDrive(const std::vector<Corridor>& corridors,
                   const std::vector<Point<PlanGround>>& corners) const {
        ASSERT_TRUE(mapOf(carved(40.0, 26.0, corridors)).save(path("site.png")));
        const auto world_from_ground =
            rigidTransform<World, PlanGround>({{3.0, -7.0}, radFromDeg(kTurn_deg)});
        std::vector<TrackPoint> track;
        for (const Point<PlanGround>& place : drivenAlong(corners)) {
            track.push_back({.t_s = 0.1 * static_cast<double>(track.size()),
                             .pose = {world_from_ground * place, 0.0}});
        }
        ASSERT_TRUE(saveTrack(file("path.csv"), track));
    }
    void saveCrookedDrive() const {
        saveDrive({{{4, -4}, {35, -4}, 2.5},
                   {{35, -4}, {35, -20}, 2.0},
                   {{12, -4}, {12, -22}, 2.0},
                   {{12, -15}, {24, -15}, 3.0},
                   {{24, -15}, {24, -22}, 2.0}},
                  {{5, -4}, {12, -4}, {12, -15}, {24, -15}, {24, -21}});
    }
    // It looks the same after half a turn.
    void saveRingDrive() const {
        saveDrive({{{5, -5}, {35, -5}},
                   {{35, -5}, {35, -21}},
                   {{35, -21}, {5, -21}},
                   {{5, -21}, {5, -5}}},
                  {{10, -5}, {35, -5}, {35, -21}, {5, -21}, {5, -10}});
    }
};

TEST_F(HedrPlanByTrail, FindsThePlaceBelowTheTrailAndWritesIt) {
    saveCrookedDrive();
    const auto found = json({"align", path("site.png"), "--trail", path("path.csv"), "--resolution",
                             "0.05", "--out", path("found.toml")});
    EXPECT_FALSE(found.at("ambiguous"));
    EXPECT_GT(found.at("score"), 0.8);
    const auto plan = loadPlan(file("found.toml"));
    ASSERT_TRUE(plan) << plan.error().detail;
    const Point<World> upper_left = plan->worldFromPlan() * Point<Plan>{};
    EXPECT_NEAR(upper_left.x, 3.0, 0.15);
    EXPECT_NEAR(upper_left.y, -7.0, 0.15);
    EXPECT_NEAR(degFromRad(plan->placement.origin.heading_rad), kTurn_deg, 0.3);
}

TEST_F(HedrPlanByTrail, SaysThatARingIsAmbiguousAndTakesThePickedPlace) {
    saveRingDrive();
    const QStringList align{"align", path("site.png"), "--trail", path("path.csv")};
    const auto first = json(align);
    EXPECT_TRUE(first.at("ambiguous"));
    ASSERT_GE(first.at("placements").size(), 2U);
    EXPECT_EQ(first.at("placement"), first.at("placements")[0].at("placement"));
    const Outcome second =
        run(kHedrTool,
            QStringList{"plan"} + align + QStringList{"--pick", "2", "--out", path("second.toml")});
    EXPECT_EQ(second.exit_code, 0) << second.err.toStdString();
    EXPECT_TRUE(second.out.contains("\nambiguous  several fit")) << second.out.toStdString();
    EXPECT_TRUE(second.out.contains("\nfit 2      score ")) << second.out.toStdString();
    const auto plan = loadPlan(file("second.toml"));
    ASSERT_TRUE(plan) << plan.error().detail;
    const double turned_deg = first.at("placements")[1].at("placement").at("rotation_deg");
    EXPECT_NEAR(degFromRad(plan->placement.origin.heading_rad), turned_deg, 1e-6);
}

TEST_F(HedrPlanByTrail, SaysInOneSentenceWhyItCannot) {
    saveCrookedDrive();
    const QStringList align{"plan", "align", path("site.png"), "--trail", path("path.csv")};
    expectFailure(align + QStringList{"--resolution", "1e9"}, {"site.png", "resolution"});
    expectFailure(align + QStringList{"--pick", "9", "--out", path("x.toml")}, {"--pick", "9"});
    expectFailure(align + QStringList{"--out", path("site.png")}, {"that is read"});
    EXPECT_FALSE(QFile::exists(path("x.toml")));
    write("short.csv", "t_s,x_m,y_m,heading_rad\n0,0,0,0\n1,5,0,0\n");
    expectFailure({"plan", "align", path("site.png"), "--trail", path("short.csv")},
                  {"short.csv", "20 m"});
    expectFailure({"plan", "align", path("site.png"), "--trail", path("none.csv")}, {"none.csv"});
}

TEST_F(HedrPlanByTrail, TakesPointsOrATrailAndNotBoth) {
    const QString image = path("a.png");
    expectWrongUsage({"plan", "align", image}, {"POINTS.csv", "--trail"});
    expectWrongUsage({"plan", "align", image, "p.csv", "--trail", "t.csv"}, {"--trail"});
    expectWrongUsage({"plan", "align", image, "--trail", "t.csv", "--keep-scale"}, {"--trail"});
    expectWrongUsage({"plan", "align", image, "p.csv", "--pick", "2"}, {"--trail"});
    expectWrongUsage({"plan", "align", image, "--trail", "t.csv", "--pick", "0"}, {"--pick"});
}

TEST_F(HedrPlan, ConvertsToWhatIsReadBackAsThePlaceThatItWas) {
    const PlanPlacement placement = loadPlan(file("a.toml"))->placement;
    ASSERT_TRUE(json({"convert", path("a.toml"), "--to", "ros", "--out", path("ros.yaml")})
                    .contains("files"));
    ASSERT_TRUE(json({"convert", path("ros.yaml"), "--to", "toml", "--out", path("b.toml")})
                    .contains("files"));
    const auto back = loadPlan(file("b.toml"));
    ASSERT_TRUE(back) << back.error().detail;
    EXPECT_EQ(back->image_file, file("ros.pgm"));
    EXPECT_NEAR(back->placement.origin.heading_rad, placement.origin.heading_rad, 1e-12);

    ASSERT_TRUE(json({"convert", path("a.toml"), "--to", "geotiff", "--tie", "48,11,0", "--out",
                      path("c.tif")})
                    .contains("files"));
    const auto tiff = loadPlan(file("c.tif"));
    ASSERT_TRUE(tiff) << tiff.error().detail;
    EXPECT_NEAR(tiff->placement.origin.position.x, placement.origin.position.x, 1e-3);
    EXPECT_NEAR(tiff->placement.origin.position.y, placement.origin.position.y, 1e-3);
    EXPECT_NEAR(tiff->placement.origin.heading_rad, placement.origin.heading_rad, 1e-5);
    EXPECT_FALSE(json({"info", path("c.tif")}).at("geo_tie").is_null());

    QFile::copy(path("a.png"), path("d.png"));
    ASSERT_TRUE(json({"convert", path("a.toml"), "--to", "world", "--out", path("d.pgw")})
                    .contains("files"));
    const auto world = loadPlan(file("d.png"));
    ASSERT_TRUE(world) << world.error().detail;
    EXPECT_NEAR(world->placement.origin.position.x, placement.origin.position.x, 1e-9);
}

TEST_F(HedrPlan, RectifiesByCorners) {
    const auto flat = json({"rectify", path("a.png"), "--corners", "50,40,350,60,360,250,40,240",
                            "--aspect", "1.5", "--out", path("flat.png")});
    EXPECT_NEAR(flat.at("aspect"), 1.5, 1e-9);
    EXPECT_TRUE(flat.at("confidence").is_null());
    EXPECT_TRUE(flat.at("usual_formats").empty()) << "the shape is known";
    const QImage image(path("flat.png"));
    EXPECT_EQ(image.width(), flat.at("width_px"));
    EXPECT_GT(image.width(), 300);
}

TEST_F(HedrPlan, NamesTheUsualFormatsThatAPhotoMayShow) {
    const QStringList rectify{"rectify",   path("a.png"),
                              "--corners", "50,50,247,50,247,190,50,190",
                              "--out",     path("flat.png")};
    const auto formats = json(rectify).at("usual_formats");
    ASSERT_FALSE(formats.empty());
    EXPECT_NEAR(formats[0].at("aspect"), std::sqrt(2.0), 1e-9);
    EXPECT_GT(formats[0].at("probability"), 0.5);
    const Outcome text = run(kHedrTool, QStringList{"plan"} + rectify);
    EXPECT_TRUE(text.out.contains("\nperhaps    A4")) << text.out.toStdString();
    EXPECT_TRUE(text.out.contains("--aspect 1.414")) << text.out.toStdString();
}

TEST_F(HedrPlan, SaysInOneSentenceWhyItCannot) {
    write("p.csv", "plan_x_px,plan_y_px,world_x_m,world_y_m\n0,0,0,0\n");
    expectFailure({"plan", "align", path("a.png"), path("p.csv")}, {"p.csv", "two at least"});
    expectFailure({"plan", "align", path("a.png"), path("none.csv")}, {"none.csv"});
    expectFailure({"plan", "info", path("p.csv")}, {"p.csv", "not an image"});
    expectFailure({"plan", "convert", path("a.toml"), "--to", "geotiff", "--out", path("x.tif")},
                  {"--tie", "globe"});
    expectFailure({"plan", "convert", path("a.toml"), "--to", "world", "--out", path("a.png")},
                  {"a.png", "that is read"});
    expectFailure({"plan", "rectify", path("a.png"), "--out", path("x.png")}, {"--corners"});
    expectFailure({"plan", "rectify", path("a.png"), "--corners", "0,0,10,0,20,0,30,0", "--out",
                   path("x.png")},
                  {});
    EXPECT_FALSE(QFile::exists(path("x.tif")) || QFile::exists(path("x.png")));
}

TEST_F(HedrPlan, LeavesWhatItReadsAndWhatIsNotItsOwn) {
    write("p.csv", kPoints);
    const QStringList refused[] = {
        {"align", path("a.png"), path("p.csv"), "--out", path("p.csv")},
        {"convert", path("a.toml"), "--to", "world", "--out", path("a.toml")},
        {"rectify", path("a.toml"), "--corners", "0,0,9,0,9,9,0,9", "--out", path("a.toml")},
        {"convert", path("a.toml"), "--to", "ros", "--out", path("b.pgm")}};
    for (const QStringList& arguments : refused) {
        const Outcome outcome = run(kHedrTool, QStringList{"plan"} + arguments);
        EXPECT_EQ(outcome.exit_code, 1) << arguments.join(' ').toStdString();
        EXPECT_EQ(outcome.err.count('\n'), 1) << outcome.err.toStdString();
    }
    write("a.tif.part", "precious");
    EXPECT_EQ(run(kHedrTool, {"plan", "convert", path("a.png"), "--to", "geotiff", "--tie",
                              "52,21,0", "--out", path("a.tif")})
                  .exit_code,
              0);
    EXPECT_EQ(readTextFile(file("a.tif.part")).value(), "precious");
}

TEST_F(HedrPlan, SpeaksJsonOfNamesThatAreNoUtf8) {
    write("p.csv", QByteArray(kPoints).replace("door", "T\xfcr"));
    EXPECT_EQ(json({"align", path("a.png"), path("p.csv")}).at("residuals").size(), 5u);
}

TEST_F(HedrPlan, FindsWrongUsageBeforeItWorks) {
    expectWrongUsage({"plan"}, {"subcommand"});
    expectWrongUsage({"plan", "polish"}, {});
    expectWrongUsage({"plan", "convert", path("a.png"), "--to", "bmp", "--out", path("x")},
                     {"geotiff"});
    expectWrongUsage({"plan", "convert", path("a.png"), "--to", "toml"}, {"--out"});
    expectWrongUsage({"plan", "align", path("a.png"), path("p.csv"), "--tie", "91,0,0"},
                     {"LATITUDE"});
    expectWrongUsage({"plan", "rectify", path("a.png"), "--out", "x", "--corners", "1,2,3"},
                     {"8 numbers"});
}

TEST_F(HedrPlan, MissionInfoNamesFloorsAndPlans) {
    {
        auto mission = MissionWriter::create(file("m.hedr"), {});
        const Site site{.floors = {{.name = "Ground", .plans = {{.image_file = file("a.png")}}},
                                   {.name = "Upper"}}};
        ASSERT_TRUE(mission && mission->writeSite(0.0, site));
    }
    const Outcome text = run(kHedrTool, {"info", path("m.hedr")});
    EXPECT_TRUE(text.out.contains("floor     Ground: a.png\nfloor     Upper\n"))
        << text.out.toStdString();
    const Outcome json = run(kHedrTool, {"info", path("m.hedr"), "--json"});
    const auto floors = nlohmann::json::parse(json.out.toStdString()).at("floors");
    ASSERT_EQ(floors.size(), 2u);
    EXPECT_EQ(floors[0].at("plans")[0], file("a.png"));
}

}  // namespace
}  // namespace hedr
