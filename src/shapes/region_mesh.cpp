#include "shapes/region_mesh.h"

#include <algorithm>
#include <map>
#include <set>

namespace rb {

namespace {

double single(double x) { return static_cast<double>(static_cast<float>(x)); }

struct Edge {
    Vec2 low;  ///< low.y < high.y
    Vec2 high;

    double at(double y) const {
        if (y == low.y) return low.x;
        if (y == high.y) return high.x;
        return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
    }
};

class Strips {
public:
    explicit Strips(const std::vector<std::vector<Vec2>>& loops) {
        for (const auto& loop : loops) add_loop(loop);
        add_intersections();
        for (const Edge& edge : edges_) {
            for (auto y = levels_.lower_bound(edge.low.y); y != levels_.end() && *y <= edge.high.y; ++y)
                point(single(edge.at(*y)), *y);
        }
    }

    RegionMesh mesh() {
        for (auto y = levels_.begin(); y != levels_.end() && std::next(y) != levels_.end(); ++y)
            fill(*y, *std::next(y));
        std::set<std::array<uint32_t, 2>> directed;
        for (const auto& t : mesh_.triangles) {
            for (size_t k = 0; k < 3; ++k) directed.insert({t[k], t[(k + 1) % 3]});
        }
        for (const auto& edge : directed) {
            if (!directed.contains({edge[1], edge[0]})) mesh_.border.push_back(edge);
        }
        return std::move(mesh_);
    }

private:
    void add_loop(const std::vector<Vec2>& loop) {
        for (size_t i = 0; i < loop.size(); ++i) {
            const Vec2& p = loop[i];
            const Vec2& q = loop[(i + 1) % loop.size()];
            Edge edge{{single(p.x), single(p.y)}, {single(q.x), single(q.y)}};
            levels_.insert(edge.low.y);
            point(edge.low.x, edge.low.y);
            if (edge.low.y > edge.high.y) std::swap(edge.low, edge.high);
            if (edge.low.y < edge.high.y) edges_.push_back(edge);
        }
    }

    /// Where two edges change their order from one end of their common heights to the other.
    void add_intersections() {
        std::ranges::sort(edges_, {}, [](const Edge& e) { return e.low.y; });
        for (size_t i = 0; i < edges_.size(); ++i) {
            const Edge& a = edges_[i];
            for (size_t k = i + 1; k < edges_.size() && edges_[k].low.y < a.high.y; ++k) {
                const Edge& b = edges_[k];
                const double y0 = b.low.y;
                const double y1 = std::min(a.high.y, b.high.y);
                const double before = a.at(y0) - b.at(y0);
                const double after = a.at(y1) - b.at(y1);
                if (!((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0))) continue;
                levels_.insert(single(y0 + (y1 - y0) * (before / (before - after))));
            }
        }
    }

    uint32_t point(double x, double y) {
        const auto [it, is_new] = rows_[y].try_emplace(x, static_cast<uint32_t>(mesh_.points.size()));
        if (is_new) mesh_.points.push_back({x, y});
        return it->second;
    }

    /// The points from one edge to another at a level.
    std::vector<uint32_t> chain(double y, const Edge& a, const Edge& b) {
        // Where they cross, rounding may have them change sides.
        const auto [left, right] = std::minmax({single(a.at(y)), single(b.at(y))});
        std::vector<uint32_t> out;
        const auto& row = rows_[y];
        for (auto p = row.lower_bound(left); p != row.end() && p->first <= right; ++p)
            out.push_back(p->second);
        return out;
    }

    /// The part of the region between two neighbouring levels.
    void fill(double y0, double y1) {
        const double middle = 0.5 * (y0 + y1);
        std::vector<const Edge*> met;
        for (const Edge& edge : edges_) {
            if (edge.low.y > y0) break;
            if (edge.high.y >= y1) met.push_back(&edge);
        }
        std::ranges::sort(met, {}, [&](const Edge* e) { return e->at(middle); });
        for (size_t i = 0; i + 1 < met.size(); i += 2) {
            join(chain(y0, *met[i], *met[i + 1]), chain(y1, *met[i], *met[i + 1]));
        }
    }

    void join(const std::vector<uint32_t>& low, const std::vector<uint32_t>& high) {
        size_t i = 0;
        size_t k = 0;
        const auto share = [](size_t at, size_t size) {
            return static_cast<double>(at + 1) / static_cast<double>(size);
        };
        while (i + 1 < low.size() || k + 1 < high.size()) {
            const bool lower =
                k + 1 >= high.size() || (i + 1 < low.size() && share(i, low.size()) <= share(k, high.size()));
            if (lower) {
                mesh_.triangles.push_back({low[i], low[i + 1], high[k]});
                ++i;
            } else {
                mesh_.triangles.push_back({low[i], high[k + 1], high[k]});
                ++k;
            }
        }
    }

    std::vector<Edge> edges_;
    std::set<double> levels_;
    std::map<double, std::map<double, uint32_t>> rows_;
    RegionMesh mesh_;
};

}  // namespace

RegionMesh triangulate(const std::vector<std::vector<Vec2>>& loops) { return Strips(loops).mesh(); }

}  // namespace rb
