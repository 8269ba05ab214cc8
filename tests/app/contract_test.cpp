// The contract with the programs that call POV-Ray, row by row (contract.txt): literal command lines, exit
// codes, files, and the texts that they look for. RB_CONTRACT_PROGRAM=/usr/bin/povray shows that the rows
// themselves are right.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <sys/wait.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

struct Check {
    std::string kind;  ///< "exit", "err", "no-err", "out", "png", "made", "not-made", "same"
    std::string argument;
    int line = 0;
};

struct Row {
    std::string name;
    std::string command;
    bool ours_only = false;  ///< the reference does not do this; differences.md says so
    std::vector<std::pair<std::string, std::string>> files;
    std::vector<Check> checks;
    friend void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }
};

/// The program that is tested instead of ours, to show that the rows are true of it; null: none.
const char* other_program() { return std::getenv("RB_CONTRACT_PROGRAM"); }

/// The rows for the program at hand. The file's own description stands at its head.
std::vector<Row> read_rows() {
    std::vector<Row> rows;
    std::vector<std::pair<std::string, std::string>> common;
    std::ifstream in(fs::path(RB_SOURCE_DIR) / "tests/app/contract.txt");
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.empty() || line.front() == '#') continue;
        std::string word = line.substr(0, line.find(' '));
        std::string rest = line.size() > word.size() ? line.substr(word.size() + 1) : "";
        if (word == "==" || word == "=+") {
            rows.push_back({rest, "", word == "=+", {}, {}});
        } else if (word == "file") {
            std::string text;
            for (; std::getline(in, line) && line != "end"; ++number) text += line + "\n";
            ++number;
            (rows.empty() ? common : rows.back().files).emplace_back(rest, text);
        } else if (word == "$") {
            rows.back().command += (rows.back().command.empty() ? "" : "\n") + rest;
        } else {
            rows.back().checks.push_back({word, rest, number});
        }
    }
    if (other_program()) std::erase_if(rows, [](const Row& row) { return row.ours_only; });
    for (Row& row : rows) row.files.insert(row.files.begin(), common.begin(), common.end());
    return rows;
}

std::string read_text(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Width, height, bits and channels of a PNG file as "640x480 8 3"; empty if it is none.
std::string png_facts(const std::string& bytes) {
    if (bytes.size() < 33 || !bytes.starts_with("\x89PNG\r\n\x1a\n")) return {};
    const auto byte = [&](size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(bytes[i])); };
    const auto word = [&](size_t i) {
        return byte(i) << 24 | byte(i + 1) << 16 | byte(i + 2) << 8 | byte(i + 3);
    };
    constexpr unsigned channels[] = {1, 0, 3, 1, 2, 0, 4};
    return fmt::format("{}x{} {} {}", word(16), word(20), byte(24), byte(25) < 7 ? channels[byte(25)] : 0);
}

class Contract : public testing::TestWithParam<Row> {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / fmt::format("rb_contract_{}", getpid());
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "bin");
        fs::create_directories(folder_ / "work/dir with blank");
        const char* other = other_program();
        fs::create_symlink(other ? fs::path(other) : fs::path(RB_BINARY_DIR) / "renderboy",
                           folder_ / "bin/povray");
        for (const auto& [name, text] : GetParam().files) {
            fs::create_directories((work() / name).parent_path());
            std::ofstream(work() / name, std::ios::binary) << text;
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path work() const { return folder_ / "work"; }

    int run() const {
        std::ofstream(folder_ / "command.sh") << GetParam().command << "\n";
        const std::string line = fmt::format(
            "cd {0}/work && PATH={0}/bin:$PATH HOME={0} POVINI=./empty.ini timeout -k 5 60 sh ../command.sh "
            ">../out 2>../err",
            folder_.string());
        const int status = std::system(line.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    void check(const Check& c, int code) const {
        const std::string said = read_text(folder_ / "err");
        const std::string out = read_text(folder_ / "out");
        const auto found = [](const std::string& text, const std::string& pattern) {
            return std::regex_search(text, std::regex(pattern));
        };
        SCOPED_TRACE(fmt::format("contract.txt:{}", c.line));
        if (c.kind == "exit") {
            EXPECT_EQ(code, std::stoi(c.argument)) << said;
        } else if (c.kind == "err") {
            EXPECT_TRUE(found(said, c.argument)) << c.argument << "\n" << said;
        } else if (c.kind == "no-err") {
            EXPECT_FALSE(found(said, c.argument)) << c.argument << "\n" << said;
        } else if (c.kind == "out") {
            EXPECT_TRUE(found(out.substr(0, 20000), c.argument)) << c.argument << "\n" << out.substr(0, 200);
        } else if (c.kind == "png") {
            const size_t blank = c.argument.find(": ");
            const std::string name = c.argument.substr(0, blank);
            EXPECT_EQ(png_facts(name == "-" ? out : read_text(work() / name)), c.argument.substr(blank + 2))
                << said;
        } else if (c.kind == "made") {
            EXPECT_TRUE(fs::exists(work() / c.argument)) << said;
        } else if (c.kind == "not-made") {
            EXPECT_FALSE(fs::exists(work() / c.argument));
        } else {
            ADD_FAILURE() << "no such check: " << c.kind;
        }
    }

    fs::path folder_;
};

TEST_P(Contract, Holds) {
    const int code = run();
    EXPECT_FALSE(GetParam().checks.empty());
    for (const Check& c : GetParam().checks) check(c, code);
}

std::string test_name(const testing::TestParamInfo<Row>& info) {
    std::string name = info.param.name;
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Rows, Contract, testing::ValuesIn(read_rows()), test_name);

}  // namespace
}  // namespace rb
