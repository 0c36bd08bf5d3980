// A mission file of which anything may be wrong: read and salvaged without a crash, and what the
// salvage writes is a mission. The first byte chooses: the bytes are a file of their own, or damage
// to a good one (places and values, and where it is cut).
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "core/mission/mission_reader.h"
#include "core/mission/mission_salvage.h"
#include "core/mission/mission_writer.h"

namespace {

using namespace hedr;
namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

void demand(bool holds) {
    if (!holds) std::abort();
}

// One for each process: several fuzz at the same time.
fs::path scratchFolder() {
    const fs::path memory = "/dev/shm";
    const fs::path folder = (fs::exists(memory) ? memory : fs::temp_directory_path()) /
                            ("mission_reader_fuzz." + std::to_string(::getpid()));
    fs::create_directories(folder);
    return folder;
}

class Scratch {
  public:
    Scratch() : folder_(scratchFolder()) {}
    ~Scratch() {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    fs::path operator/(const char* name) const { return folder_ / name; }

  private:
    fs::path folder_;
};

Bytes contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// A row of everything that a mission can hold, in a few pages.
Bytes goodMission(const fs::path& file) {
    {
        auto mission = MissionWriter::create(file, {.start = {}, .program_version = "fuzz"});
        demand(mission.has_value());
        (void)mission->writeVehicle({});
        (void)mission->writePlan({"plan.png", {}, std::nullopt});
        Site site;
        site.floors.push_back({.name = "Floor 1"});
        (void)mission->writeSite(0.0, site);
        const Bytes row(200, 0x5A);
        for (int i = 0; i < 40; ++i) {
            (void)mission->writeBytes(0.1 * i, row);
            const TrackPoint point{0.1 * i};
            (void)mission->writeEstimates("hedr", std::span(&point, 1));
        }
        (void)mission->writeStreamMark(5.0, StreamKind::kPortLost);
        (void)mission->writeEvent(5.0, "note", "text");
        (void)mission->writeLinkSample({.receive_time_s = 5.0});
        (void)mission->writeRejected({3, 1});
        demand(mission->commit().has_value());
    }
    return contentOf(file);
}

// Four bytes each: where (three, of the whole length) and the new value. The last two bytes of the
// input say how much of the file is left.
Bytes damaged(Bytes file, std::span<const std::uint8_t> damage) {
    if (damage.size() >= 2) {
        const std::size_t cut = damage[damage.size() - 2] * 256U + damage[damage.size() - 1];
        damage = damage.first(damage.size() - 2);
        if (cut != 0) file.resize(file.size() * cut / 65536);
    }
    for (; damage.size() >= 4 && !file.empty(); damage = damage.subspan(4)) {
        const std::size_t place = damage[0] * 65536U + damage[1] * 256U + damage[2];
        file[place % file.size()] = damage[3];
    }
    return file;
}

void readAll(const fs::path& file) {
    const auto mission = MissionReader::open(file);
    if (!mission) return;
    (void)mission->info();
    (void)mission->forEachStreamRow([](const StreamRow&) { return true; });
    if (const auto tracks = mission->tracks()) {
        for (const std::string& track : *tracks) (void)mission->estimates(track);
    }
    (void)mission->events();
    (void)mission->linkSamples();
    (void)mission->rejected();
    (void)mission->vehicle();
    (void)mission->plan();
    (void)mission->site();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Scratch scratch;
    static const Bytes good = goodMission(scratch / "good.hedr");
    if (size == 0) return 0;
    const std::span<const std::uint8_t> input(data + 1, size - 1);
    const Bytes bytes = data[0] % 8 == 0 ? Bytes(input.begin(), input.end()) : damaged(good, input);
    const fs::path file = scratch / "m.hedr";
    const fs::path out = scratch / "out.hedr";
    for (const fs::path& old : {file, out}) {
        for (const char* log : {"", "-wal", "-shm"}) fs::remove(old.string() + log);
    }
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    readAll(file);
    if (salvageMission(file, out)) {
        const auto saved = MissionReader::open(out);
        demand(saved.has_value());
        demand(saved->forEachStreamRow([](const StreamRow&) { return true; }).has_value());
    }
    return 0;
}
