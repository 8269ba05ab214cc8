// The kD-tree of a mesh beside Embree and beside brute force: build, memory, rays per second, one ray at a
// time. Prints tables in Markdown. Usage: kdtree_bench [bumpy|soup|all] [least triangles] [most triangles]
// [runs]
#include "base/parallel.h"
#include "bumpy.h"
#include "shapes/mesh_shape.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <embree3/rtcore.h>
#include <random>
#include <string>
#include <thread>

#include <fmt/format.h>

namespace {

using namespace rb;

double cpu_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
double thread_seconds() { return cpu_seconds(CLOCK_THREAD_CPUTIME_ID); }
double process_seconds() { return cpu_seconds(CLOCK_PROCESS_CPUTIME_ID); }
double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Single triangles of all directions scattered through a cube; a ray that crosses it meets about 8 of any
/// number.
TriangleMesh soup(size_t count) {
    TriangleMesh mesh;
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    std::normal_distribution<double> normal;
    const double size = 3.0 / std::sqrt(static_cast<double>(count));
    const auto corner = [&](const Vec3& center) {
        const Vec3 d{normal(random), normal(random), normal(random)};
        mesh.vertices.emplace_back(center + size * d);
    };
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3 center{place(random), place(random), place(random)};
        for (int k = 0; k < 3; ++k) corner(center);
        mesh.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
}

/// Single precision all through, so that both programs get the same ray.
struct TestRay {
    Vec3f origin;
    Vec3f direction;
    float far = std::numeric_limits<float>::infinity();
};
struct TestHit {
    bool met = false;
    double t = 0;
};

class Ours {
public:
    explicit Ours(const TriangleMesh& mesh, MeshSearch search = MeshSearch::fastest) {
        MeshData data;
        data.triangles = mesh;
        shape_ = std::make_unique<MeshShape>("mesh2", std::move(data), search);
    }
    void build(int threads) {
        const ThreadLimit limit(threads);
        shape_->prepare();
    }
    size_t memory() const { return shape_->tree_memory(); }
    TestHit closest(const TestRay& r) const {
        const Ray ray{Vec3(r.origin), Vec3(r.direction)};
        Crossing nearest;
        if (!shape_->closest(ShapeRay{ray}, nullptr, nearest)) return {};
        return {true, nearest.t};
    }
    TestHit any(const TestRay& r) const {
        const Ray ray{Vec3(r.origin), Vec3(r.direction)};
        ShapeRay query{ray};
        query.t_max = static_cast<double>(r.far);
        Crossing found;
        return {shape_->any(query, nullptr, found), 0.0};
    }

private:
    std::unique_ptr<MeshShape> shape_;
};

class Embree {
public:
    explicit Embree(const TriangleMesh& mesh) : mesh_(&mesh) {}
    ~Embree() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;

    /// High quality (with spatial splits), robust. `threads` = 0: all.
    void build(int threads) {
        if (!device_) prepare(threads);
        rtcCommitScene(scene_);
    }
    /// Everything up to the build itself.
    void prepare(int threads) {
        device_ = rtcNewDevice(fmt::format("threads={}", threads).c_str());
        rtcSetDeviceMemoryMonitorFunction(
            device_,
            [](void* self, ssize_t bytes, bool) {
                static_cast<Embree*>(self)->memory_.fetch_add(bytes);
                return true;
            },
            this);
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh_->vertices.size()));
        for (const Vec3f& v : mesh_->vertices) {
            for (int k = 0; k < 3; ++k) *vertices++ = v[k];
        }
        auto* faces = static_cast<uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh_->faces.size()));
        for (const auto& face : mesh_->faces) {
            for (const uint32_t corner : face) *faces++ = corner;
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        before_ = memory_;
    }
    /// Without the vertices and faces.
    size_t memory() const { return static_cast<size_t>(memory_ - before_); }
    TestHit closest(const TestRay& r) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRayHit query{};
        query.ray = ray(r);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(scene_, &context, &query);
        return {query.hit.geomID != RTC_INVALID_GEOMETRY_ID, static_cast<double>(query.ray.tfar)};
    }
    TestHit any(const TestRay& r) const {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        RTCRay query = ray(r);
        rtcOccluded1(scene_, &context, &query);
        return {query.tfar < 0.0f, 0.0};
    }

private:
    static RTCRay ray(const TestRay& r) {
        RTCRay out{};
        out.org_x = r.origin.x, out.org_y = r.origin.y, out.org_z = r.origin.z;
        out.dir_x = r.direction.x, out.dir_y = r.direction.y, out.dir_z = r.direction.z;
        out.tnear = 0.0f;
        out.tfar = r.far;
        out.mask = ~0u;
        return out;
    }

    const TriangleMesh* mesh_;
    RTCDevice device_ = nullptr;
    RTCScene scene_ = nullptr;
    std::atomic<ssize_t> memory_ = 0;
    ssize_t before_ = 0;
};

struct RayKind {
    std::string_view name;
    bool any;
    std::vector<TestRay> rays;
};

/// Camera rays row by row; rays of all directions from anywhere in the mesh's box; rays from where camera
/// rays hit to a light.
std::vector<RayKind> make_rays(const Ours& mesh, int side) {
    std::vector<RayKind> kinds{{"primary", false, {}}, {"random", false, {}}, {"shadow", true, {}}};
    const Vec3 eye{0.1, 0.3, -4};
    const Vec3 light{2, 6, -5};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    std::normal_distribution<double> normal;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Vec3 d =
                glm::normalize(Vec3{0.6 * ((x + 0.5) / side - 0.5), 0.6 * (0.5 - (y + 0.5) / side), 1.0});
            const TestRay camera{Vec3f(eye), Vec3f(d)};
            kinds[0].rays.push_back(camera);
            const TestHit hit = mesh.closest(camera);
            if (hit.met) {
                // A little before the surface: neither program is told that the ray starts there.
                const Vec3 p = eye + Vec3(camera.direction) * (hit.t * (1 - 1e-5));
                const Vec3 way = light - p;
                kinds[2].rays.push_back(
                    {Vec3f(p), Vec3f(glm::normalize(way)), static_cast<float>(glm::length(way))});
            }
            const Vec3 o{place(random), place(random), place(random)};
            const Vec3 any{normal(random), normal(random), normal(random)};
            kinds[1].rays.push_back({Vec3f(o), Vec3f(glm::normalize(any))});
        }
    }
    return kinds;
}

template <class Tracer>
size_t trace(const Tracer& tracer, const RayKind& kind, size_t begin, size_t end) {
    size_t hits = 0;
    for (size_t i = begin; i < end; ++i)
        hits += (kind.any ? tracer.any(kind.rays[i]) : tracer.closest(kind.rays[i])).met ? 1 : 0;
    return hits;
}

/// Millions of rays a second; with one thread by its CPU time, with more by the clock.
template <class Tracer>
double rate(const Tracer& tracer, const RayKind& kind, unsigned threads) {
    static std::atomic<size_t> sink;
    const size_t n = kind.rays.size();
    if (threads == 1) {
        const double start = thread_seconds();
        sink += trace(tracer, kind, 0, n);
        return 1e-6 * static_cast<double>(n) / (thread_seconds() - start);
    }
    const double start = wall_seconds();
    std::atomic<size_t> next = 0;
    std::vector<std::thread> crew;
    for (unsigned i = 0; i < threads; ++i) {
        crew.emplace_back([&] {
            constexpr size_t piece = 1024;
            for (size_t at = next.fetch_add(piece); at < n; at = next.fetch_add(piece))
                sink += trace(tracer, kind, at, std::min(at + piece, n));
        });
    }
    for (auto& thread : crew) thread.join();
    return 1e-6 * static_cast<double>(n) / (wall_seconds() - start);
}

struct Agreement {
    size_t hits = 0;
    size_t other_answer = 0;    ///< one program met something, the other nothing
    size_t other_distance = 0;  ///< by more than 1e-5 of it
};

Agreement compare(const Ours& ours, const Embree& embree, const RayKind& kind) {
    Agreement a;
    for (const TestRay& ray : kind.rays) {
        const TestHit x = kind.any ? ours.any(ray) : ours.closest(ray);
        const TestHit y = kind.any ? embree.any(ray) : embree.closest(ray);
        if (x.met) ++a.hits;
        if (x.met != y.met) {
            ++a.other_answer;
        } else if (x.met && std::abs(x.t - y.t) > 1e-5 * std::max(x.t, 0.1)) {
            ++a.other_distance;
        }
    }
    return a;
}

struct BuildTimes {
    double cpu = 0;   ///< with one thread
    double wall = 0;  ///< with all
    size_t memory = 0;
};

template <class Tracer>
BuildTimes build_times(const TriangleMesh& mesh, int runs) {
    std::vector<double> cpu;
    std::vector<double> wall;
    BuildTimes times;
    for (int i = 0; i < runs; ++i) {
        for (const int threads : {1, 0}) {
            Tracer tracer(mesh);
            if constexpr (std::is_same_v<Tracer, Embree>) tracer.prepare(threads);
            const double start = threads == 1 ? process_seconds() : wall_seconds();
            tracer.build(threads);
            if (threads == 1) {
                cpu.push_back(process_seconds() - start);
            } else {
                wall.push_back(wall_seconds() - start);
            }
            times.memory = tracer.memory();
        }
    }
    times.cpu = median(cpu);
    times.wall = median(wall);
    return times;
}

void measure(std::string_view name, const TriangleMesh& mesh, int runs) {
    const auto megabytes = [](size_t bytes) { return static_cast<double>(bytes) / 1e6; };
    const BuildTimes our_build = build_times<Ours>(mesh, (runs + 1) / 2);
    const BuildTimes its_build = build_times<Embree>(mesh, (runs + 1) / 2);
    fmt::print("build | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.1f} |\n", name,
               mesh.faces.size(), our_build.cpu, its_build.cpu, our_build.cpu / its_build.cpu, our_build.wall,
               its_build.wall, megabytes(our_build.memory), megabytes(its_build.memory));

    Ours ours(mesh);
    ours.build(1);
    Embree embree(mesh);
    embree.build(1);
    const Ours brute(mesh, MeshSearch::brute_force);
    const unsigned all = std::max(2u, std::thread::hardware_concurrency());
    for (const RayKind& kind : make_rays(ours, 512)) {
        std::vector<double> ours_one, its_one, ours_all, its_all;
        for (int i = 0; i < runs; ++i) {
            ours_one.push_back(rate(ours, kind, 1));
            its_one.push_back(rate(embree, kind, 1));
            ours_all.push_back(rate(ours, kind, all));
            its_all.push_back(rate(embree, kind, all));
        }
        RayKind few{kind.name, kind.any, {}};
        const size_t wanted = std::max<size_t>(20, 100'000'000 / mesh.faces.size());
        const size_t step = std::max<size_t>(1, kind.rays.size() / wanted);
        for (size_t i = 0; i < kind.rays.size(); i += step) few.rays.push_back(kind.rays[i]);
        const double slow = rate(brute, few, 1);
        const Agreement a = compare(ours, embree, kind);
        fmt::print(
            "rays | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {} of {} | {} | {} "
            "|\n",
            name, mesh.faces.size(), kind.name, median(ours_one), median(its_one),
            median(ours_one) / median(its_one), median(ours_all), median(its_all), median(ours_one) / slow,
            a.hits, kind.rays.size(), a.other_answer, a.other_distance);
        std::fflush(stdout);
    }
}

}  // namespace

int main(int argc, char** argv) {
    const std::string wanted = argc > 1 ? argv[1] : "all";
    const auto number = [&](int i, size_t otherwise) {
        return argc > i ? static_cast<size_t>(std::atof(argv[i])) : otherwise;
    };
    const size_t least = number(2, 10'000);
    const size_t most = number(3, 10'000'000);
    const int runs = static_cast<int>(number(4, 5));
    fmt::print(
        "build | mesh | triangles | s, 1 thread | Embree | ratio | s, all | Embree | MB | Embree |\n"
        "rays | mesh | triangles | rays | Mray/s, 1 thread | Embree | ratio | all | Embree | × brute force | "
        "hits | other answer | other distance |\n");
    for (size_t n = least; n <= most; n *= 10) {
        if (wanted != "soup") measure("bumpy", bumpy(n), runs);
        if (wanted != "bumpy") measure("soup", soup(n), runs);
    }
    return 0;
}
