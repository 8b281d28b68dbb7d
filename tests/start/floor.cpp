// The minimum cost of a picture: a context, one textured and lit quad at 512 x 512, and a file. A hand-written program
// with the same libraries and without the framework. `relief bench start` compares `relief shot` with it. Built twice:
// floor-png TEXTURE.png OUT.png SAMPLES uses libpng, and floor-ppm TEXTURE.ppm OUT.ppm SAMPLES needs no library for
// files. SAMPLES: samples per pixel; a shot has four.
#include <glad/gl.h>  // before osmesa.h, which would bring the system's gl.h

// glad undefines these names at its end, but the header of Mesa 25 needs them.
#ifndef APIENTRY
    #define APIENTRY GLAD_API_PTR
#endif
#ifndef GLAPI
    #define GLAPI extern
#endif
#include <GL/osmesa.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#ifdef FLOOR_PNG
    #include <png.h>
#endif

namespace {

constexpr int side = 512;

struct Picture {  // RGB, 8 bits
    int width = 0, height = 0;
    std::vector<unsigned char> rows;
};

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::exit(1);
}

#ifdef FLOOR_PNG
Picture read(const char* file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, file)) fail(std::string("cannot read ") + file);
    image.format = PNG_FORMAT_RGB;
    Picture picture{int(image.width), int(image.height), {}};
    picture.rows.resize(size_t(picture.width) * size_t(picture.height) * 3);
    if (!png_image_finish_read(&image, nullptr, picture.rows.data(), 0, nullptr))
        fail(std::string("cannot read ") + file);
    return picture;
}
void write(const char* file, const Picture& picture) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION, image.format = PNG_FORMAT_RGB;
    image.width = png_uint_32(picture.width), image.height = png_uint_32(picture.height);
    if (!png_image_write_to_file(&image, file, 0, picture.rows.data(), 0, nullptr))
        fail(std::string("cannot write ") + file);
}
#else
Picture read(const char* file) {
    std::ifstream stream(file, std::ios::binary);
    Picture picture;
    std::string kind;
    int largest = 0;
    stream >> kind >> picture.width >> picture.height >> largest;
    if (!stream || kind != "P6" || largest != 255) fail(std::string("cannot read ") + file);
    stream.ignore(1);
    picture.rows.resize(size_t(picture.width) * size_t(picture.height) * 3);
    stream.read(reinterpret_cast<char*>(picture.rows.data()), std::streamsize(picture.rows.size()));
    return picture;
}
void write(const char* file, const Picture& picture) {
    std::ofstream stream(file, std::ios::binary);
    stream << "P6\n" << picture.width << ' ' << picture.height << "\n255\n";
    stream.write(reinterpret_cast<const char*>(picture.rows.data()), std::streamsize(picture.rows.size()));
    if (!stream.flush()) fail(std::string("cannot write ") + file);
}
#endif

constexpr const char* vertex_shader = R"(#version 410 core
layout(location = 0) in vec4 a_place;  // x, y, u, v
out vec2 v_uv;
out vec3 v_position;
void main() {
    v_uv = a_place.zw;
    v_position = vec3(a_place.xy, 0.0);
    gl_Position = vec4(a_place.xy, 0.0, 1.0);
}
)";
constexpr const char* fragment_shader = R"(#version 410 core
in vec2 v_uv;
in vec3 v_position;
uniform sampler2D s_albedo;
out vec4 o_color;
void main() {
    vec3 normal = vec3(0.0, 0.0, 1.0);
    vec3 to_light = normalize(vec3(0.5, 0.7, 1.0) - v_position), to_eye = normalize(vec3(0.0, 0.0, 2.0) - v_position);
    float diffuse = max(dot(normal, to_light), 0.0);
    float highlight = pow(max(dot(normal, normalize(to_light + to_eye)), 0.0), 48.0);
    vec3 light = texture(s_albedo, v_uv).rgb * (0.1 + diffuse) + 0.3 * highlight;
    o_color = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}
)";

GLuint compiled(GLenum stage, const char* text) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) fail("a shader does not compile");
    return shader;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) fail("usage: floor TEXTURE OUT SAMPLES");
    const int samples = std::atoi(argv[3]);
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              4,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              1,
                              0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    std::vector<unsigned char> window(side * side * 4);
    if (!context || !OSMesaMakeCurrent(context, window.data(), GL_UNSIGNED_BYTE, side, side)) fail("no context");
    if (!gladLoadGL(reinterpret_cast<GLADloadfunc>(OSMesaGetProcAddress))) fail("no OpenGL");

    const Picture albedo = read(argv[1]);
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, albedo.width, albedo.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 albedo.rows.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);

    const GLuint program = glCreateProgram();
    glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex_shader));
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, fragment_shader));
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) fail("the program does not link");

    constexpr float corners[] = {-0.9f, -0.9f, 0, 0, 0.9f, -0.9f, 1, 0, -0.9f, 0.9f, 0, 1, 0.9f, 0.9f, 1, 1};
    GLuint layout = 0, buffer = 0;
    glGenVertexArrays(1, &layout);
    glBindVertexArray(layout);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);

    GLuint target = 0, surfaces[2] = {};
    if (samples > 1) {
        glGenFramebuffers(1, &target);
        glBindFramebuffer(GL_FRAMEBUFFER, target);
        glGenRenderbuffers(2, surfaces);
        constexpr GLenum formats[] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
        constexpr GLenum places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
        for (int i = 0; i < 2; ++i) {
            glBindRenderbuffer(GL_RENDERBUFFER, surfaces[i]);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, formats[i], side, side);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, surfaces[i]);
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) fail("no samples");
    }

    glClearColor(0.1f, 0.1f, 0.1f, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

    if (samples > 1) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, side, side, 0, 0, side, side, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    }
    Picture picture{side, side, std::vector<unsigned char>(side * side * 3)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    std::vector<unsigned char> upwards(picture.rows.size());
    glReadPixels(0, 0, side, side, GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
    if (glGetError() != GL_NO_ERROR) fail("OpenGL complains");
    for (int y = 0; y < side; ++y)
        std::copy_n(upwards.begin() + (side - 1 - y) * side * 3, side * 3, picture.rows.begin() + y * side * 3);
    write(argv[2], picture);
    OSMesaDestroyContext(context);
}
