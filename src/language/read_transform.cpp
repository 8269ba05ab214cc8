// translate, rotate, scale, matrix, transform. Language spec 13.
#include "language/read.h"

#include <cmath>

#include <fmt/format.h>

namespace rb {

namespace {

Transform take_scale(BlockReader& in) {
    const SourceRange at = in.where();
    Vec3 factors = in.vec3();
    constexpr const char* axes = "XYZ";
    for (int k = 0; k < 3; ++k) {
        if (factors[k] != 0.0) continue;
        in.diagnostics().warning(at, fmt::format("Illegal Value: Scale {} by 0.0. Changed to 1.0.", axes[k]));
        factors[k] = 1.0;
    }
    return Transform::scaling(factors);
}

Transform take_matrix(BlockReader& in) {
    const SourceRange at = in.where();
    std::vector<double> m;
    in.numbers(12, 1, m);
    Affine matrix;
    for (size_t r = 0; r < 4; ++r) matrix.row[r] = {m[3 * r], m[3 * r + 1], m[3 * r + 2]};
    for (int column = 0; column < 3; ++column) {
        const bool empty = std::abs(matrix.row[0][column]) < 1e-10 &&
                           std::abs(matrix.row[1][column]) < 1e-10 && std::abs(matrix.row[2][column]) < 1e-10;
        if (!empty) continue;
        in.diagnostics().warning(at, "Illegal matrix column: Scale by 0.0. Changed to 1.0.");
        matrix.row[static_cast<size_t>(column)][column] = 1.0;
    }
    const std::optional<Transform> map = Transform::from_matrix(matrix);
    if (!map) in.fail_at(at, "Singular matrix in MInvers.");
    return *map;
}

}  // namespace

bool take_transformation(BlockReader& in, Transform& map) {
    using Shared = std::shared_ptr<const Transform>;
    Transform step;
    if (in.take_word("translate")) {
        step = Transform::translation(in.vec3());
    } else if (in.take_word("rotate")) {
        step = Transform::rotation_deg(in.vec3());
    } else if (in.take_word("scale")) {
        step = take_scale(in);
    } else if (in.take_word("matrix")) {
        step = take_matrix(in);
    } else if (in.at_block("transform")) {
        step = *read_transform(in.block("transform"), in.context());
    } else if (in.take_word("transform")) {
        if (!in.at_thing<Shared>())
            in.fail(fmt::format("Expected 'transform identifier', {} found instead", in.found()));
        step = *in.thing<Shared>();
    } else {
        return false;
    }
    map = map.is_identity() ? step : then(map, step);
    return true;
}

std::shared_ptr<const Transform> read_transform(const Block& block, const ReadContext& context) {
    using Shared = std::shared_ptr<const Transform>;
    BlockReader in(block, context);
    Transform map;
    bool inverse = false;
    while (!in.at_end()) {
        if (in.take_word("inverse")) {
            inverse = true;
        } else if (in.at_thing<Shared>()) {
            map = then(map, *in.thing<Shared>());
        } else if (!take_transformation(in, map)) {
            break;
        }
    }
    in.finish();
    return std::make_shared<const Transform>(inverse ? map.inverse() : map);
}

}  // namespace rb
