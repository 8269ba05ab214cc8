#include "app/commands.h"
#include "app/compare_page.h"
#include "app/console.h"
#include "base/diagnostics.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

#include <fmt/format.h>

namespace rb {

namespace {

/// The folder where runs are kept, or one that goes away again.
class RunFolder {
public:
    explicit RunFolder(const std::optional<std::string>& kept) : kept_(kept.has_value()) {
        namespace fs = std::filesystem;
        path_ = kept ? fs::path(*kept)
                     : fs::temp_directory_path() / fmt::format("renderboy_compare_{}", getpid());
        std::error_code failed;
        fs::create_directories(path_, failed);
        if (failed) throw IoError(fmt::format("{}: {}", path_.string(), failed.message()));
    }
    ~RunFolder() {
        std::error_code ignored;
        if (!kept_) std::filesystem::remove_all(path_, ignored);
    }
    RunFolder(const RunFolder&) = delete;
    RunFolder& operator=(const RunFolder&) = delete;

    std::string path() const { return path_.string(); }

private:
    bool kept_;
    std::filesystem::path path_;
};

enum class Verdict { passed, failed, not_rendered_by_povray };

Verdict judge(const CompareSettings& settings, const ComparedScene& scene) {
    if (scene.povray.picture.empty()) return Verdict::not_rendered_by_povray;
    if (!scene.difference) return Verdict::failed;
    return settings.limits.hold(*scene.difference) ? Verdict::passed : Verdict::failed;
}

std::string line_of(const ComparedScene& scene, Verdict verdict) {
    constexpr std::string_view words[] = {"", "  over the limit", "  not rendered by povray"};
    std::string out = fmt::format("{:<44} ", scene.scene);
    if (scene.difference) {
        const ImageDifference& d = *scene.difference;
        out += fmt::format("{:>8.3f} {:>8.3f} {:>7.4f} {:>9.3f} {:>9.3f} {:>6.2f}", 100.0 * d.share_off,
                           d.rmse, d.ssim, scene.povray.run.cpu, scene.ours.run.cpu,
                           scene.povray.run.cpu / scene.ours.run.cpu);
    } else {
        out += scene.note;
    }
    return out + std::string(words[static_cast<size_t>(verdict)]) + "\n";
}

std::string summary_of(const std::vector<ComparedScene>& scenes) {
    constexpr double exact = 0.001;
    constexpr double close = 0.01;
    constexpr double alike = 0.95;
    size_t both = 0, exact_ones = 0, close_ones = 0, alike_ones = 0, by_povray = 0, crashed = 0;
    double cpu = 0, memory = 0;
    const ComparedScene* slowest = nullptr;
    const auto ratio = [](const ComparedScene& s) { return s.povray.run.cpu / s.ours.run.cpu; };
    for (const ComparedScene& s : scenes) {
        by_povray += s.povray.picture.empty() ? 0 : 1;
        constexpr int by_signal = 128;
        crashed += s.ours.run.exit_code >= by_signal && !s.ours.run.timed_out ? 1 : 0;
        if (!s.difference) continue;
        ++both;
        exact_ones += s.difference->share_off <= exact ? 1 : 0;
        close_ones += s.difference->share_off <= close ? 1 : 0;
        alike_ones += s.difference->ssim >= alike ? 1 : 0;
        cpu += std::log(ratio(s));
        memory += std::log(static_cast<double>(s.povray.run.peak_memory_kib) /
                           static_cast<double>(s.ours.run.peak_memory_kib));
        if (!slowest || ratio(s) < ratio(*slowest)) slowest = &s;
    }
    std::string out = fmt::format(
        "{} scenes, {} rendered by povray, {} by both, {} crashes\nat most 0.1 % off: {}; at most 1 %: {}; "
        "ssim 0.95 or more: {}\n",
        scenes.size(), by_povray, both, crashed, exact_ones, close_ones, alike_ones);
    if (slowest) {
        const auto n = static_cast<double>(both);
        out += fmt::format(
            "povray by renderboy, geometric means: CPU {:.2f}, memory {:.2f}; least CPU ratio {:.2f} ({})\n",
            std::exp(cpu / n), std::exp(memory / n), ratio(*slowest), slowest->scene);
    }
    return out;
}

}  // namespace

int run_compare(const CompareSettings& settings) {
    const RunFolder folder(settings.cache);
    const SceneComparison comparison(settings, folder.path());
    print(fmt::format("{:<44} {:>8} {:>8} {:>7} {:>9} {:>9} {:>6}\n", "scene", "off, %", "rmse", "ssim",
                      "povray, s", "ours, s", "ratio"));
    std::vector<ComparedScene> scenes;
    bool passed = true;
    for (const SceneToCompare& scene : settings.scenes) {
        scenes.push_back(comparison.compare(scene));
        const Verdict verdict = judge(settings, scenes.back());
        passed = passed && verdict != Verdict::failed;
        print(line_of(scenes.back(), verdict));
    }
    const std::string summary = summary_of(scenes);
    print(summary);
    if (settings.table) write_compare_table(scenes, *settings.table);
    if (settings.html) write_compare_page(scenes, summary, *settings.html);
    return passed ? exit_done : exit_error;
}

}  // namespace rb
