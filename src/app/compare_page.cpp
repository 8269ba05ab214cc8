#include "app/compare_page.h"

#include "base/diagnostics.h"
#include "base/temporary_file.h"
#include "base/whole_file.h"
#include "image/file.h"

#include <array>
#include <fstream>
#include <functional>

#include <fmt/format.h>

namespace rb {

namespace {

struct Column {
    std::string_view name;
    std::string_view title;  ///< what it means
    std::function<std::string(const ComparedScene&)> cell;
};

std::string number(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }
std::string number(const std::optional<double>& value, int digits) {
    return value ? number(*value, digits) : "";
}

std::string memory(const ComparedSide& side) {
    constexpr double kib_per_mib = 1024.0;
    return number(static_cast<double>(side.run.peak_memory_kib) / kib_per_mib, 0);
}

const std::vector<Column>& columns() {
    using S = const ComparedScene&;
    const auto of_difference = [](double ImageDifference::*value, double scale, int digits) {
        return [=](S s) { return s.difference ? number(scale * (*s.difference).*value, digits) : ""; };
    };
    static const std::vector<Column> all{
        {"scene", "", [](S s) { return s.scene; }},
        {"off", "share of pixels off by more than 8/255, %",
         of_difference(&ImageDifference::share_off, 100.0, 3)},
        {"rmse", "of 255", of_difference(&ImageDifference::rmse, 1.0, 3)},
        {"ssim", "structural similarity", of_difference(&ImageDifference::ssim, 1.0, 4)},
        {"povray", "CPU seconds", [](S s) { return number(s.povray.run.cpu, 3); }},
        {"renderboy", "CPU seconds", [](S s) { return number(s.ours.run.cpu, 3); }},
        {"ratio", "CPU seconds, povray's by renderboy's",
         [](S s) { return s.difference ? number(s.povray.run.cpu / s.ours.run.cpu, 2) : ""; }},
        {"povray wall", "seconds", [](S s) { return number(s.povray.run.wall, 3); }},
        {"renderboy wall", "seconds", [](S s) { return number(s.ours.run.wall, 3); }},
        {"povray parse", "seconds, as it tells", [](S s) { return number(s.povray.parse, 3); }},
        {"renderboy parse", "CPU seconds", [](S s) { return number(s.ours.parse, 3); }},
        {"povray trace", "wall seconds, as it tells", [](S s) { return number(s.povray.render, 3); }},
        {"renderboy trace", "wall seconds", [](S s) { return number(s.ours.render, 3); }},
        {"povray memory", "MiB", [](S s) { return memory(s.povray); }},
        {"renderboy memory", "MiB", [](S s) { return memory(s.ours); }},
        {"note", "", [](S s) { return s.note; }},
    };
    return all;
}

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += c;
        }
    }
    return out;
}

/// RFC 4648, section 4.
std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t three = 0;
        for (size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            out += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63u];
    }
    return out;
}

std::string image_cell(const std::string& picture) {
    if (picture.empty()) return "<td></td>";
    return fmt::format("<td><img src=\"data:image/png;base64,{}\"></td>",
                       base64(read_whole_file(picture).value_or("")));
}

std::string difference_cell(const ComparedScene& scene, const std::string& beside) {
    if (!scene.difference) return "<td></td>";
    const TemporaryFile file(beside);
    const Pixels heat = heat_map(read_image(scene.ours.picture), read_image(scene.povray.picture));
    write_image(rows_of(heat), OutputFormat{}, file.name());
    return image_cell(file.name());
}

constexpr std::string_view head = R"(<!doctype html><meta charset="utf-8"><title>RenderBoy and POV-Ray</title>
<style>
body { font: 13px sans-serif; margin: 1em } td, th { padding: 2px 8px; text-align: right; border-bottom: 1px solid #ddd }
th { cursor: pointer; position: sticky; top: 0; background: #eee } td:first-child, td:last-child { text-align: left }
img { max-width: 320px; image-rendering: pixelated } img:hover { max-width: none }
</style>
)";

constexpr std::string_view script = R"(<script>
const body = document.querySelector('tbody');
document.querySelectorAll('th').forEach((th, column) => th.addEventListener('click', () => {
  const value = row => { const text = row.cells[column].textContent; return text === '' || isNaN(text) ? text : +text; };
  const sign = th.dataset.sign = th.dataset.sign === '1' ? '-1' : '1';
  [...body.rows].sort((a, b) => { const x = value(a), y = value(b); return sign * (x < y ? -1 : x > y ? 1 : 0); })
    .forEach(row => body.append(row));
}));
</script>
)";

void write_file(const std::string& path, const std::function<void(std::ostream&)>& fill) {
    TemporaryFile file(path);
    std::ofstream out(file.name(), std::ios::binary);
    fill(out);
    out.close();
    if (!out || !file.put_in_place(path)) throw IoError(fmt::format("{}: cannot be written", path));
}

}  // namespace

void write_compare_page(const std::vector<ComparedScene>& scenes, const std::string& summary,
                        const std::string& path) {
    write_file(path, [&](std::ostream& out) {
        out << head << "<pre>" << escaped(summary) << "</pre>\n<table><thead><tr>";
        for (const Column& column : columns())
            out << fmt::format("<th title=\"{}\">{}</th>", escaped(column.title), column.name);
        out << "<th>renderboy</th><th>povray</th><th>difference</th></tr></thead><tbody>\n";
        for (const ComparedScene& scene : scenes) {
            out << "<tr>";
            for (const Column& column : columns()) out << "<td>" << escaped(column.cell(scene)) << "</td>";
            out << image_cell(scene.ours.picture) << image_cell(scene.povray.picture)
                << difference_cell(scene, path + ".png") << "</tr>\n";
        }
        out << "</tbody></table>\n" << script;
    });
}

void write_compare_table(const std::vector<ComparedScene>& scenes, const std::string& path) {
    write_file(path, [&](std::ostream& out) {
        const auto row = [&](auto&& cell) {
            for (size_t i = 0; i < columns().size(); ++i) out << (i > 0 ? "\t" : "") << cell(columns()[i]);
            out << '\n';
        };
        row([](const Column& column) { return std::string(column.name); });
        for (const ComparedScene& scene : scenes)
            row([&](const Column& column) { return column.cell(scene); });
    });
}

}  // namespace rb
