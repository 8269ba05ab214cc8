#include "app/scene_comparison.h"

#include "base/diagnostics.h"
#include "base/temporary_file.h"
#include "base/whole_file.h"
#include "image/file.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rb {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string text_of(const std::string& path) { return read_whole_file(path).value_or(""); }

/// Size and time of last change.
std::string identity_of(const std::string& path) {
    std::error_code failed;
    const auto size = fs::file_size(path, failed);
    const auto changed = fs::last_write_time(path, failed);
    if (failed) throw IoError(fmt::format("{}: {}", path, failed.message()));
    return fmt::format("{} {} {}", path, size, changed.time_since_epoch().count());
}

/// "Trace Time: ... (0.245 seconds)" in POV-Ray's statistics.
std::optional<double> seconds_behind(std::string_view log, std::string_view label) {
    const size_t at = log.find(label);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view line = log.substr(at, log.find('\n', at) - at);
    const size_t open = line.find('(');
    if (open == std::string_view::npos) return std::nullopt;
    double value = 0;
    const auto read = std::from_chars(line.data() + open + 1, line.data() + line.size(), value);
    if (read.ec != std::errc{}) return std::nullopt;
    return value;
}

/// The first line that speaks of an error, else the last one.
std::string complaint_in(const std::string& log) {
    std::istringstream lines(log);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        if (line.find("rror") != std::string::npos) return line;
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    }
    return last;
}

void read_times(ComparedSide& side, bool ours, const std::string& stats, const std::string& log) {
    if (!ours) {
        side.parse = seconds_behind(log, "Parse Time:");
        side.render = seconds_behind(log, "Trace Time:");
        return;
    }
    const auto told = ordered_json::parse(text_of(stats), nullptr, false);
    if (told.is_discarded() || !told.contains("seconds")) return;
    side.parse = told["seconds"]["parse_cpu"].get<double>();
    side.render = told["seconds"]["render"].get<double>();
}

ordered_json json_of(const ComparedSide& side) {
    ordered_json out{{"exit_code", side.run.exit_code},
                     {"timed_out", side.run.timed_out},
                     {"wall", side.run.wall},
                     {"cpu", side.run.cpu},
                     {"memory_kib", side.run.peak_memory_kib},
                     {"error", side.error}};
    if (side.parse) out["parse"] = *side.parse;
    if (side.render) out["render"] = *side.render;
    return out;
}

/// Empty if the file is not there or broken.
std::optional<ComparedSide> kept_side(const std::string& path) {
    const auto told = ordered_json::parse(text_of(path), nullptr, false);
    if (!told.is_object()) return std::nullopt;
    ComparedSide side;
    side.run = {told.value("exit_code", 1), told.value("timed_out", false), told.value("wall", 0.0),
                told.value("cpu", 0.0), told.value("memory_kib", uint64_t{0})};
    side.error = told.value("error", "");
    if (told.contains("parse")) side.parse = told["parse"].get<double>();
    if (told.contains("render")) side.render = told["render"].get<double>();
    return side;
}

void keep(const ComparedSide& side, const std::string& path) {
    TemporaryFile file(path);
    std::ofstream(file.name()) << json_of(side).dump(1) << '\n';
    if (!file.put_in_place(path)) throw IoError(fmt::format("{}: cannot be written", path));
}

}  // namespace

SceneComparison::SceneComparison(const CompareSettings& settings, const std::string& folder)
    : settings_(settings), folder_(fs::absolute(folder).string()) {
    povray_.path = find_program(settings.povray);
    if (povray_.path.empty()) throw IoError(fmt::format("{}: no such program", settings.povray));
    povray_.path = fs::absolute(povray_.path).string();
    povray_.identity = identity_of(povray_.path);
    ours_.path = fs::read_symlink("/proc/self/exe").string();
    ours_.identity = identity_of(ours_.path);
    ours_.is_ours = true;
}

std::vector<std::string> SceneComparison::words_of(const SceneToCompare& scene) const {
    const fs::path path = fs::absolute(scene.path);
    std::vector<std::string> words{
        "+I" + path.string(), "+L" + path.parent_path().string(), "+W320", "+H240", "-D", "-P", "+FN8"};
    words.insert(words.end(), settings_.words.begin(), settings_.words.end());
    words.insert(words.end(), scene.words.begin(), scene.words.end());
    return words;
}

ComparedSide SceneComparison::side(const Program& program, const SceneToCompare& scene) const {
    std::vector<std::string> command = words_of(scene);
    std::string key = program.identity + identity_of(scene.path);
    for (const std::string& word : command) key += '\n' + word;
    const std::string name =
        fmt::format("{}/{}_{}_{:016x}", folder_, fs::path(scene.path).stem().string(),
                    program.is_ours ? "renderboy" : "povray", std::hash<std::string>{}(key));
    const std::string picture = name + ".png";
    const std::string figures = name + ".json";
    auto found = kept_side(figures);
    if (!found) {
        fs::remove(picture);
        const std::string stats = name + ".stats";
        const std::string log = name + ".log";
        command.insert(command.begin(), program.path);
        command.push_back("+O" + picture);
        if (program.is_ours) command.insert(command.end(), {"--stats", stats});
        found = ComparedSide{run_measured(command, log, settings_.timeout), {}, {}, "", ""};
        const std::string said = text_of(log);
        if (found->run.exit_code == 0) {
            read_times(*found, program.is_ours, stats, said);
        } else {
            found->error = found->run.timed_out ? "too slow" : complaint_in(said);
        }
        fs::remove(stats);
        fs::remove(log);
        keep(*found, figures);
    }
    if (found->run.exit_code == 0 && fs::exists(picture)) found->picture = picture;
    return *found;
}

ComparedScene SceneComparison::compare(const SceneToCompare& scene) const {
    ComparedScene out;
    out.scene = scene.path;
    out.povray = side(povray_, scene);
    out.ours = side(ours_, scene);
    if (out.povray.picture.empty() || out.ours.picture.empty()) {
        const bool theirs = out.povray.picture.empty();
        out.note = fmt::format("{}: {}", theirs ? "povray" : "renderboy",
                               theirs ? out.povray.error : out.ours.error);
        return out;
    }
    try {
        out.difference = rb::compare(read_image(out.povray.picture), read_image(out.ours.picture));
    } catch (const IoError& error) {
        out.note = error.what();
    }
    return out;
}

}  // namespace rb
