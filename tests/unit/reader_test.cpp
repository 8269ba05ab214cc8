#include "block/reader.h"

#include <gtest/gtest.h>

namespace rb {
namespace {

/// box { <1,2,3> 0.5 <7,8> }
Block sample() {
    Block block;
    block.keyword = "box";
    block.where = {1, 0, 30};
    block.numbers = {1, 2, 3, 0.5, 7, 8};
    Item vector{.kind = Item::Kind::numbers, .where = {1, 6, 13}, .first = 0, .count = 1, .terms = 3};
    Item scalar{.kind = Item::Kind::numbers, .where = {1, 14, 17}, .first = 3, .count = 1, .terms = 1};
    Item pair{.kind = Item::Kind::numbers, .where = {1, 18, 23}, .first = 4, .count = 1, .terms = 2};
    block.items = {vector, scalar, pair};
    return block;
}

struct Fixture : testing::Test {
    Diagnostics diagnostics;
    ReadContext context;
    Fixture() { context.diagnostics = &diagnostics; }
};

using ReaderTest = Fixture;

TEST_F(ReaderTest, PromotesAsTheLanguageDoes) {
    const Block block = sample();
    BlockReader in(block, context);
    EXPECT_EQ(in.vec3(), Vec3(1, 2, 3));
    EXPECT_EQ(in.vec3(), Vec3(0.5));
    EXPECT_EQ(in.vec3(), Vec3(7, 8, 0));
    EXPECT_TRUE(in.at_end());
    EXPECT_NO_THROW(in.finish());
}

TEST_F(ReaderTest, WrongTermCountIsAnErrorAtItsPlace) {
    const Block block = sample();
    BlockReader in(block, context);
    try {
        in.number();
        FAIL();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.diagnostic().where, (SourceRange{1, 6, 13}));
        EXPECT_EQ(error.diagnostic().message, "Float expected but vector or color expression found.");
    }
}

TEST_F(ReaderTest, WhatIsLeftOverIsAnError) {
    const Block block = sample();
    BlockReader in(block, context);
    in.vec3();
    EXPECT_THROW(in.finish(), SceneError);
}

TEST_F(ReaderTest, LongListsComeOutPacked) {
    Block block;
    block.keyword = "vertex_vectors";
    for (int i = 0; i < 300; ++i) block.numbers.push_back(i);
    block.items = {Item{.kind = Item::Kind::numbers, .first = 0, .count = 100, .terms = 3}};
    BlockReader in(block, context);
    EXPECT_EQ(in.vec3(), Vec3(0, 1, 2));
    std::vector<double> out;
    in.numbers(99, 3, out);
    ASSERT_EQ(out.size(), 297u);
    EXPECT_EQ(out.back(), 299.0);
    EXPECT_THROW(in.numbers(1, 3, out), SceneError);
}

// Language spec 10, measured as probe 11.
TEST(Promote, ColorWords) {
    WrittenColor rgbt{
        .has_base = true, .word_terms = 4, .transmit_fourth = true, .base = {{.1, .2, .3, .4}, 4}};
    EXPECT_EQ(promote(rgbt, 5), (Color{.1f, .2f, .3f, 0, .4f}));
    WrittenColor bare{.has_base = true, .bare = true, .base = {{.5}, 1}};
    EXPECT_EQ(promote(bare, 5), (Color{.5f, .5f, .5f, .5f, .5f}));
    EXPECT_EQ(promote(bare, 3), (Color{.5f, .5f, .5f, 0, 0}));
    WrittenColor edited{.has_base = true, .word_terms = 3, .base = {{.1, .2, .3}, 3}};
    edited.set[3] = .25;
    EXPECT_EQ(promote(edited, 5), (Color{.1f, .2f, .3f, .25f, 0}));
    EXPECT_EQ(promote(WrittenColor{}, 5), Color{});
}

}  // namespace
}  // namespace rb
