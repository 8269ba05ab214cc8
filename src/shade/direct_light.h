#pragma once
#include "shade/finish_terms.h"
#include "shade/shadow.h"

namespace rb {

/// One place to be lit: a hit with the normal and pigment of one layer.
struct LitRow {
    uint32_t hit = 0;   ///< index into StreamState::hits
    uint32_t root = 0;  ///< row in the group, for the shadow memory
    bool double_illuminate = false;
    LitPlace place;
    Rgb light{0.0f};  ///< result
};

/// What arrives from each light of a list at each hit of a group, so that layers and blended textures of one
/// hit share their shadow rays.
class ShadowMemory {
public:
    ShadowMemory(size_t rows, size_t lights, bool keep, Scratch::Scope& memory);

    /// Null if not known (or not kept).
    const Rgb* find(size_t row, size_t light) const {
        return keep_ && known_[row * lights_ + light] ? &colors_[row * lights_ + light] : nullptr;
    }
    bool knows(size_t row, size_t light) const { return keep_ && known_[row * lights_ + light] != 0; }
    void store(size_t row, size_t light, const Rgb& color) {
        if (!keep_) return;
        known_[row * lights_ + light] = 1;
        colors_[row * lights_ + light] = color;
    }

private:
    bool keep_;
    size_t lights_;
    std::span<Rgb> colors_;
    std::span<uint8_t> known_;
};

/// Adds the light of all light sources (manual 3.4.4, 3.4.6.3).
class DirectLight {
public:
    DirectLight(const ShadingProgram& program, StreamState& state)
        : program_(program), state_(state), shadows_(program, state) {}

    /// `lights`: indices into ShadingProgram::lights; the memory numbers them as this list does.
    void add(const FinishProgram& finish, std::span<LitRow> rows, std::span<const uint32_t> lights,
             ShadowMemory& memory);

private:
    struct Columns;
    struct Ways;
    struct Reached;
    struct ListedLight {
        size_t index;  ///< into ShadingProgram::lights
        size_t place;  ///< in the list
    };
    static bool knows_all(std::span<const LitRow> rows, std::span<const Reached> places, size_t light,
                          const ShadowMemory& memory);
    const Candidates* candidates(const LightProgram& source, std::span<const LitRow> rows,
                                 std::span<const Reached> places, const Columns& columns, const Ways& ways);
    static void look_toward(const LightProgram& source, const Columns& rows, Ways& ways);
    size_t find_lit(const FinishProgram& finish, size_t light, std::span<const LitRow> rows,
                    const Columns& columns, const Ways& ways, std::span<Reached> reached) const;
    double crand(const FinishProgram& finish, size_t light, const LitRow& row) const;
    Rgb from_area(const FinishProgram& finish, const ListedLight& light, const LitRow& row,
                  const LightVector& way, ShadowMemory& memory);
    Rgb thin_film(const FinishProgram& finish, const LitRow& row, const Vec3& to_light) const;
    Rgb arriving(const ListedLight& light, const LitRow& row, const LightVector& way, const Rgb& color,
                 const Candidates* candidates, ShadowMemory& memory);

    const ShadingProgram& program_;
    StreamState& state_;
    ShadowTracer shadows_;
    Candidates candidates_;  ///< of the rows and the light at hand
};

}  // namespace rb
