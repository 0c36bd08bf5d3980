#include <benchmark/benchmark.h>

#include <QApplication>
#include <array>
#include <iomanip>
#include <iostream>
#include <map>

namespace {

// What is compared with the plain form beside it: times differ between machines, ratios hardly.
struct Comparison {
    const char* ours;
    const char* reference;
};

constexpr std::array kComparisons{
    Comparison{"decodeGoodFrames/4096", "referenceCrc16"},
    Comparison{"sharpRender/100000", "qpainterChunks/100000"},
    Comparison{"sharpRender/1000000", "qpainterChunks/1000000"},
    Comparison{"frameWhilePanning/100000", "qpainterChunks/100000"},
    Comparison{"frameWhileZooming/100000", "qpainterChunks/100000"},
    Comparison{"frameWithTwentyNewPoints/100000", "qpainterChunks/100000"},
    Comparison{"loadWholePlan/grey_png", "decodeByQImage/grey_png"},
    Comparison{"loadWholePlan/grey_png", "decodeByOpenCv/grey_png"},
    Comparison{"loadWholePlan/grey_png", "decodeByGdal/grey_png"},
    Comparison{"loadWholePlan/colour_png", "decodeByQImage/colour_png"},
    Comparison{"loadWholePlan/colour_png", "decodeByOpenCv/colour_png"},
    Comparison{"loadWholePlan/colour_png", "decodeByGdal/colour_png"},
    Comparison{"loadWholePlan/jpeg", "decodeByGdal/jpeg"},
    Comparison{"allanOfTenMillion", "plainAllanOfTenMillion"},
};

// The usual table, and behind it the ratios.
class RatioReporter : public benchmark::ConsoleReporter {
  public:
    RatioReporter() : ConsoleReporter(OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            failed_ = failed_ || run.error_occurred;
            cpu_s_[run.benchmark_name()] = seconds(run);
        }
        ConsoleReporter::ReportRuns(runs);
    }

    void Finalize() override {
        std::cout << "\nCPU time as a share of the reference's\n";
        for (const Comparison& pair : kComparisons) {
            if (!cpu_s_.contains(pair.ours) || !cpu_s_.contains(pair.reference)) continue;
            std::cout << std::setw(8) << std::setprecision(3)
                      << cpu_s_[pair.ours] / cpu_s_[pair.reference] << "  " << pair.ours << " / "
                      << pair.reference << '\n';
        }
    }

    bool failed() const { return failed_; }

  private:
    static double seconds(const Run& run) {
        return run.GetAdjustedCPUTime() / benchmark::GetTimeUnitMultiplier(run.time_unit);
    }

    std::map<std::string, double> cpu_s_;
    bool failed_ = false;
};

// What QApplication starts leaves the upper halves of the vector registers in use. From then on SSE
// instructions wait for them, and the estimators would measure eight times slower than in `hedr`.
void tidyVectorRegisters() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx")) asm volatile("vzeroupper");
#endif
}

}  // namespace

// Widgets are drawn in some benchmarks, so all of them run inside one application.
int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    const QApplication application(argc, argv);
    tidyVectorRegisters();
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return reporter.failed() ? 1 : 0;
}
