// The module relief-peers.so: the only user of Assimp, Embree, and OpenImageIO's textures for bump mapping.
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>
#include <unistd.h>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#if RELIEF_EMBREE == 4
    #include <embree4/rtcore.h>
#else
    #include <embree3/rtcore.h>
#endif

#include "framework/core/base/error.h"
#include "framework/staff/measure/peers.h"

namespace relief::measure {
namespace {

class Tangents final : public PeerTangents {
public:
    explicit Tangents(const Mesh& mesh) {
        const std::string text = obj_text(mesh);
        // Joins identical vertices, as in the original mesh.
        if (!importer_.ReadFileFromMemory(text.data(), text.size(), aiProcess_JoinIdenticalVertices, "obj") ||
            importer_.GetScene()->mNumMeshes != 1 ||
            importer_.GetScene()->mMeshes[0]->mNumFaces != mesh.indices.size() / 3)
            throw Error(std::string("Assimp cannot read the mesh: ") + importer_.GetErrorString());
        // Assimp's number parser rounds and cannot read all exponents of a float, so restore the exact numbers.
        aiMesh& read = this->mesh();
        for (unsigned face = 0; face < read.mNumFaces; ++face)
            for (unsigned corner = 0; corner < 3; ++corner) {
                const unsigned i = read.mFaces[face].mIndices[corner];
                const Vertex& vertex = mesh.vertices[mesh.indices[3 * face + corner]];
                read.mVertices[i] = {vertex.position.x, vertex.position.y, vertex.position.z};
                read.mNormals[i] = {vertex.normal.x, vertex.normal.y, vertex.normal.z};
                read.mTextureCoords[0][i] = {vertex.uv.x, vertex.uv.y, 0};
            }
    }

    void run() override {
        aiMesh& mesh = this->mesh();
        delete[] mesh.mTangents;
        delete[] mesh.mBitangents;
        mesh.mTangents = mesh.mBitangents = nullptr;
        if (!importer_.ApplyPostProcessing(aiProcess_CalcTangentSpace) || !mesh.mTangents)
            throw Error(std::string("Assimp makes no tangents: ") + importer_.GetErrorString());
    }

    std::vector<glm::vec4> tangents() const override {
        const aiMesh& mesh = const_cast<Tangents*>(this)->mesh();
        std::vector<glm::vec4> result;
        for (unsigned face = 0; face < mesh.mNumFaces; ++face)
            for (unsigned corner = 0; corner < 3; ++corner) {
                const unsigned i = mesh.mFaces[face].mIndices[corner];
                const aiVector3D t = mesh.mTangents[i];
                const float hand = ((mesh.mNormals[i] ^ t) * mesh.mBitangents[i]) < 0 ? -1.0f : 1.0f;
                result.emplace_back(t.x, t.y, t.z, hand);
            }
        return result;
    }

private:
    // The importer exposes its scene as const. Removing its tangents makes it compute them again.
    aiMesh& mesh() { return *const_cast<aiMesh*>(importer_.GetScene()->mMeshes[0]); }

    Assimp::Importer importer_;
};

class Hits final : public PeerHits {
public:
    Hits(const Mesh& mesh, bool robust, bool any_machine)
        : device_(rtcNewDevice(any_machine ? "threads=1,isa=sse2" : "threads=1")) {
        const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        void* const positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                        3 * sizeof(float), mesh.vertices.size());
        void* const indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                      3 * sizeof(unsigned), mesh.indices.size() / 3);
        if (!positions || !indices) throw Error("Embree has no memory for the mesh");
        for (size_t i = 0; i < mesh.vertices.size(); ++i)
            std::copy_n(&mesh.vertices[i].position.x, 3, static_cast<float*>(positions) + 3 * i);
        std::copy(mesh.indices.begin(), mesh.indices.end(), static_cast<unsigned*>(indices));
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(scene_);
        if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw Error("Embree cannot take the mesh");
    }
    ~Hits() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void run(const std::vector<Ray>& rays, std::vector<double>& hits) override {
        hits.clear();
        for (const Ray& ray : rays) {
            const glm::vec3 origin(ray.origin), direction(ray.direction);
            RTCRayHit hit{};
            hit.ray.org_x = origin.x, hit.ray.org_y = origin.y, hit.ray.org_z = origin.z;
            hit.ray.dir_x = direction.x, hit.ray.dir_y = direction.y, hit.ray.dir_z = direction.z;
            hit.ray.tfar = 2, hit.ray.mask = ~0u, hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RELIEF_EMBREE == 4
            rtcIntersect1(scene_, &hit);
#else
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            rtcIntersect1(scene_, &context, &hit);
#endif
            hits.push_back(hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? -1 : double(hit.ray.tfar));
        }
    }

private:
    RTCDevice device_;
    RTCScene scene_ = rtcNewScene(device_);
};

}  // namespace
}  // namespace relief::measure

extern "C" {

std::unique_ptr<relief::measure::PeerTangents> relief_assimp_tangents(const relief::Mesh& mesh) {
    return std::make_unique<relief::measure::Tangents>(mesh);
}

std::unique_ptr<relief::measure::PeerHits> relief_embree_hits(const relief::Mesh& mesh, bool robust, bool any_machine) {
    return std::make_unique<relief::measure::Hits>(mesh, robust, any_machine);
}

void relief_assimp_model(const std::filesystem::path& path) {
    Assimp::Importer importer;
    if (!importer.ReadFile(path.string(), aiProcess_JoinIdenticalVertices | aiProcess_Triangulate))
        throw relief::Error(std::string("Assimp cannot read the model: ") + importer.GetErrorString());
}

void relief_openimageio_pixels(const std::filesystem::path& path) {
    OIIO::attribute("threads", 1);
    OIIO::ImageBuf picture(path.string());
    if (!picture.read(0, 0, true, OIIO::TypeDesc::FLOAT))
        throw relief::Error("OpenImageIO cannot read the picture: " + picture.geterror());
}

void relief_openimageio_slopes(const relief::Image& heights, relief::Image& slopes) {
    const OIIO::ImageSpec spec(heights.width, heights.height, 1, OIIO::TypeDesc::FLOAT);
    const OIIO::ImageBuf map(spec, const_cast<float*>(heights.values.data()));
    OIIO::ImageSpec settings;
    settings.format = OIIO::TypeDesc::FLOAT;
    settings.attribute("maketx:bumpformat", "height");
    settings.attribute("maketx:wrap", "periodic");
    settings.attribute("wrapmodes", "periodic,periodic");
    settings.attribute("maketx:nomipmap", 1);
    char name[] = "/tmp/relief-slopes-XXXXXX.exr";
    const int file = mkstemps(name, 4);
    if (file < 0) throw relief::Error("cannot make a file for OpenImageIO's texture");
    close(file);
    const bool made = OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxBumpWithSlopes, map, name, settings);
    OIIO::ImageBuf texture(name);
    const bool read = made && texture.read(0, 0, true, OIIO::TypeDesc::FLOAT) && texture.nchannels() == 6;
    unlink(name);
    if (!read) throw relief::Error("OpenImageIO makes no slopes: " + OIIO::geterror());
    slopes = relief::Image(heights.width, heights.height, 2);
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x)
            for (int i = 0; i < 2; ++i) slopes.pixel(x, y)[i] = texture.getchannel(x, y, 0, 1 + i);
}

}  // extern "C"
