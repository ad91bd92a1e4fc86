#include "web/hours/hours_counter.hpp"

#include "preprocess/base/vectors.hpp"
#include "src/hours/schedule.hpp"
#include "src/hours/surfaces/cell_light.hpp"
#include "src/hours/surfaces/division.hpp"
#include "src/hours/surfaces/left_out_cells.hpp"
#include "src/sun/direction.hpp"
#include "src/sun/local_time.hpp"
#include "web/sentence.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace edgeshade::web {
namespace {

/// Materials of all meshes: one casts, and one doesn't. Others have holes, for a mesh each.
constexpr std::size_t casting = 0, notCasting = 1;

/// Rays between two reports.
constexpr std::size_t raysOfStep = std::size_t{1} << 18;

template <class T>
const T* at(std::uintptr_t address) {
    return reinterpret_cast<const T*>(address);
}

template <class T>
emscripten::val viewOfAll(const std::vector<T>& values) {
    return emscripten::val(emscripten::typed_memory_view(values.size(), values.data()));
}

void append(const glm::dvec3& vector, std::vector<double>& to) {
    to.insert(to.end(), {vector.x, vector.y, vector.z});
}

} // namespace

bool HoursCounter::Clipping::clips(const glm::dvec3& place) const {
    const auto isBelow = [&](const glm::dvec4& plane) {
        return glm::dot(glm::dvec3(plane), place) + plane.w < 0.0;
    };
    return intersection ? std::all_of(planes.begin(), planes.end(), isBelow)
                        : std::any_of(planes.begin(), planes.end(), isBelow);
}

HoursCounter::HoursCounter() {
    scene_.materials.resize(2);
    clippings_.resize(2);
    scene_.materials[notCasting].alphaMode = AlphaMode::blend;
}

std::string HoursCounter::setDays(double latitude, double longitude, const std::string& from,
                                  const std::string& to, const std::string& offset, int step,
                                  double opens, double closes, double minAltitude, double north) {
    return sentenceOfFailure([&] {
        hours::Schedule schedule;
        schedule.place = sun::placeAt(latitude, longitude);
        schedule.from = sun::dateFromText(from);
        schedule.to = sun::dateFromText(to);
        schedule.offset =
            offset.empty() ? hours::offsetNear(longitude) : sun::offsetFromText(offset);
        schedule.step = std::chrono::minutes(step);
        schedule.opens = std::chrono::minutes(std::lround(60.0 * opens));
        schedule.closes = std::chrono::minutes(std::lround(60.0 * closes));
        schedule.minAltitude = minAltitude;
        schedule.north = north;
        for (const hours::Position& position : hours::positionsOf(schedule))
            directions_.push_back(position.direction);
    });
}

std::string HoursCounter::setTimes(double latitude, double longitude, std::uintptr_t seconds,
                                   std::size_t count, double minAltitude, double north) {
    return sentenceOfFailure([&] {
        const sun::Place place = sun::placeAt(latitude, longitude);
        for (std::size_t i = 0; i < count; ++i) {
            const sun::Instant time{std::chrono::seconds(
                static_cast<std::int64_t>(std::floor(at<double>(seconds)[i])))};
            const sun::SunPosition sun = sun::sunPosition(place, time);
            if (sun.altitude > minAltitude) directions_.push_back(sun::towardsSun(sun, north));
        }
    });
}

std::string HoursCounter::addTexels(std::uintptr_t alpha, std::size_t count, int width,
                                    int height) {
    return sentenceOfFailure([&] {
        const auto* const first = at<std::uint16_t>(alpha);
        images_.emplace(static_cast<int>(images_.size()),
                        rays::AlphaImage{width, height, {first, first + count}});
    });
}

std::string HoursCounter::addMesh(std::uintptr_t positions, std::size_t floats,
                                  std::uintptr_t indices, std::size_t count) {
    return sentenceOfFailure([&] {
        Geometry geometry;
        for (std::size_t i = 0; i + 3 <= floats; i += 3) {
            const float* const v = at<float>(positions) + i;
            geometry.positions.emplace_back(v[0] + 0.0f, v[1] + 0.0f, v[2] + 0.0f); // no -0
        }
        const auto isSound = [&](std::uint32_t index) {
            return index < geometry.positions.size() &&
                   isFinite(glm::dvec3(geometry.positions[index]));
        };
        for (std::size_t i = 0; i + 3 <= count; i += 3) {
            const std::uint32_t* const corners = at<std::uint32_t>(indices) + i;
            if (std::all_of(corners, corners + 3, isSound))
                geometry.indices.insert(geometry.indices.end(), corners, corners + 3);
        }
        castingMaterial_ = casting;
        geometry.groups = {{casting, 0, static_cast<std::uint32_t>(geometry.indices.size())}};
        Batch batch;
        batch.geometry = CopyOnWrite<Geometry>(std::move(geometry));
        batch.hidden = true;
        scene_.batches.push_back(std::move(batch));
        measured_.push_back(false);
    });
}

/// The last mesh's own material as a caster.
Material& HoursCounter::holedMaterial() {
    if (castingMaterial_ == casting) {
        castingMaterial_ = scene_.materials.size();
        scene_.materials.emplace_back();
        clippings_.emplace_back();
        Material& material = scene_.materials.back();
        material.alphaMode = AlphaMode::mask;
        material.alphaCutoff = 0.0f; // unless setAlpha() is called
    }
    return scene_.materials[castingMaterial_];
}

std::string HoursCounter::setAlpha(float opacity, float cutoff, int texels,
                                   std::uintptr_t texcoords, int wrapS, int wrapT, int filter) {
    return sentenceOfFailure([&] {
        Material& material = holedMaterial();
        material.alphaCutoff = cutoff;
        material.baseColorFactor.a = opacity;
        MaterialTexture& base = material.of(TextureSlot::baseColor);
        base.image = texels;
        base.sampler.wrapS = wrapS;
        base.sampler.wrapT = wrapT;
        base.sampler.magFilter = filter;
        Geometry& geometry = scene_.batches.back().geometry.edit();
        const std::size_t count = geometry.positions.size();
        geometry.colors.assign(count, glm::vec4(1.0f));
        geometry.texcoords.assign(count, glm::vec2(0.0f));
        if (texels < 0) return;
        const float* const uv = at<float>(texcoords);
        for (std::size_t i = 0; i < count; ++i)
            geometry.texcoords[i] = {uv[2 * i], uv[2 * i + 1]};
    });
}

std::string HoursCounter::addClipping(std::uintptr_t planes, std::size_t count, bool intersection) {
    return sentenceOfFailure([&] {
        holedMaterial();
        Clipping clipping{{}, intersection};
        for (std::size_t i = 0; i < count; ++i)
            clipping.planes.push_back(glm::make_vec4(at<double>(planes) + 4 * i));
        clippings_[castingMaterial_].push_back(std::move(clipping));
    });
}

std::string HoursCounter::place(std::uintptr_t matrix, bool casts, bool measured) {
    return sentenceOfFailure([&] {
        // The first place is that of addMesh()'s batch; others share its geometry.
        if (!scene_.batches.back().hidden) {
            scene_.batches.push_back(scene_.batches.back());
            measured_.push_back(false);
        }
        Batch& batch = scene_.batches.back();
        batch.hidden = false;
        batch.worldFromBatch = glm::make_mat4(at<double>(matrix));
        batch.placedBy = static_cast<int>(scene_.batches.size()) - 1;
        const std::size_t material = casts ? castingMaterial_ : notCasting;
        if (batch.geometry->groups.front().material != material)
            batch.geometry.edit().groups.front().material = material;
        measured_.back() = measured;
    });
}

void HoursCounter::startTracing() {
    const bool hasHoles = scene_.materials.size() > notCasting + 1;
    rays::IsHole isHole;
    if (hasHoles)
        isHole = [this](const rays::SurfaceTriangle& triangle, double u, double v) {
            return this->isHole(triangle, u, v);
        };
    rays_ = std::make_unique<hours::SensorRays>(scene_, false, hasHoles, std::move(isHole));
}

bool HoursCounter::isHole(const rays::SurfaceTriangle& triangle, double u, double v) const {
    const std::vector<Clipping>& clippings = clippings_[triangle.material];
    if (!clippings.empty()) {
        const glm::dvec3 place = rays_->origin() + triangle.a + u * (triangle.b - triangle.a) +
                                 v * (triangle.c - triangle.a);
        for (const Clipping& clipping : clippings)
            if (clipping.clips(place)) return true;
    }
    const float cutoff = scene_.materials[triangle.material].alphaCutoff;
    return cutoff > 0.0f && rays::alphaAt(scene_, images_, triangle, u, v) < cutoff;
}

void HoursCounter::begin(std::size_t count) {
    counts_.assign(count, 0);
    counted_ = 0;
}

std::string HoursCounter::measureVertices(std::uintptr_t normals) {
    return sentenceOfFailure([&] {
        startTracing();
        const Batch& batch = scene_.batches.back();
        // As rays::surfaceTriangles() places corners, so that vertices lie in their planes.
        const glm::dmat4 place =
            glm::translate(glm::dmat4(1.0), -rays_->origin()) * batch.worldFromBatch;
        const glm::dmat3 turned = glm::transpose(glm::inverse(glm::dmat3(batch.worldFromBatch)));
        for (std::size_t i = 0; i < batch.geometry->positions.size(); ++i) {
            const glm::dvec3 point(place * glm::dvec4(batch.geometry->positions[i], 1.0));
            const glm::dvec3 normal =
                turned * glm::dvec3(glm::make_vec3(at<float>(normals) + 3 * i));
            const bool sound = isFinite(point) && isFinite(normal) && normal != glm::dvec3(0.0);
            if (!sound) unsound_.push_back(i);
            vertices_.push_back(
                sound ? rays::SurfacePoint::at(point, normal, rays::SurfacePoint::none)
                      : rays::SurfacePoint());
        }
        begin(vertices_.size());
    });
}

std::string HoursCounter::measureCells(double width, double offset) {
    return sentenceOfFailure([&] {
        cells_ = hours::cellsOf(scene_,
                                [&](std::uint32_t node, std::uint32_t) { return measured_[node]; },
                                {width, offset});
        hours::markLeftOut(cells_, hours::solidSurfaces(scene_, false));
        startTracing();
        for (const hours::Cell& cell : cells_.cells) {
            append(cell.point, points_);
            append(cell.normal, normals_);
            areas_.push_back(cell.area);
            states_.push_back(static_cast<std::uint8_t>(cell.state));
            faceCounts_.push_back(cell.faceCount);
            for (std::uint32_t f = cell.firstFace; f < cell.firstFace + cell.faceCount; ++f) {
                const hours::CellFace& face = cells_.faces[f];
                cornerCounts_.push_back(face.cornerCount);
                for (std::uint32_t i = 0; i < face.cornerCount; ++i)
                    append(cells_.corners[face.firstCorner + i], corners_);
            }
        }
        begin(cells_.cells.size());
    });
}

bool HoursCounter::advance() {
    if (counted_ == counts_.size() || directions_.empty()) return true;
    problem_ = sentenceOfFailure([&] {
        const std::size_t step =
            std::max<std::size_t>(raysOfStep / directions_.size(), rays::packetSize);
        const std::size_t end = std::min(counted_ + step, counts_.size());
        const rays::LitBits bits =
            vertices_.empty()
                ? rays_->lit(hours::sensorsOf(cells_, counted_, end), directions_)
                : rays_->rays().lit(std::span(vertices_).subspan(counted_, end - counted_),
                                    directions_);
        for (std::size_t i = counted_; i < end; ++i)
            counts_[i] = static_cast<std::uint32_t>(bits.count(i - counted_));
        for (const std::size_t i : unsound_)
            counts_[i] = 0;
        counted_ = end;
    });
    return !problem_.empty() || counted_ == counts_.size();
}

double HoursCounter::share() const {
    return counts_.empty() ? 1.0
                           : static_cast<double>(counted_) / static_cast<double>(counts_.size());
}

emscripten::val HoursCounter::counts() const {
    return viewOfAll(counts_);
}
emscripten::val HoursCounter::points() const {
    return viewOfAll(points_);
}
emscripten::val HoursCounter::normals() const {
    return viewOfAll(normals_);
}
emscripten::val HoursCounter::areas() const {
    return viewOfAll(areas_);
}
emscripten::val HoursCounter::states() const {
    return viewOfAll(states_);
}
emscripten::val HoursCounter::faceCounts() const {
    return viewOfAll(faceCounts_);
}
emscripten::val HoursCounter::cornerCounts() const {
    return viewOfAll(cornerCounts_);
}
emscripten::val HoursCounter::corners() const {
    return viewOfAll(corners_);
}

} // namespace edgeshade::web
