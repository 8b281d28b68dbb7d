#include "framework/core/gl/glsl_words.h"

#include <map>
#include <vector>

#include "framework/core/base/text.h"

namespace relief {
namespace {

std::set<std::string> set_of(std::string_view words) {
    const std::vector<std::string> list = split(words, ' ');
    return {list.begin(), list.end()};
}

const std::map<std::string, std::string>& foreign_words() {
    static const std::map<std::string, std::string> words = [] {
        std::map<std::string, std::string> all = {
            // HLSL and Cg
            {"saturate", "clamp(x, 0.0, 1.0)"},
            {"lerp", "mix"},
            {"frac", "fract"},
            {"fmod", "mod, which differs for negative numbers"},
            {"rsqrt", "inversesqrt"},
            {"rcp", "1.0 / x"},
            {"mad", "a * b + c"},
            {"mul", "the operator *"},
            {"ddx", "dFdx"},
            {"ddy", "dFdy"},
            {"atan2", "atan(y, x)"},
            {"log10", "log(x) / log(10.0)"},
            {"sincos", "sin(x) and cos(x)"},
            {"clip", "if (x < 0.0) discard"},
            {"isfinite", "!isinf(x) && !isnan(x)"},
            {"tex2D", "texture(sampler, uv)"},
            {"tex2Dlod", "textureLod(sampler, uv, level)"},
            {"tex2Dgrad", "textureGrad(sampler, uv, dx, dy)"},
            {"texCUBE", "texture(sampler, direction)"},
            {"asfloat", "intBitsToFloat or uintBitsToFloat"},
            {"asint", "floatBitsToInt"},
            {"asuint", "floatBitsToUint"},
            {"countbits", "bitCount"},
            {"reversebits", "bitfieldReverse"},
            {"firstbithigh", "findMSB"},
            {"firstbitlow", "findLSB"},
            {"half", "float"},
            {"fixed", "float"},
            {"float1", "float"},
            {"static", "const, or no word at all"},
            // GLSL before 1.30
            {"texture2D", "texture(sampler, uv)"},
            {"texture2DLod", "textureLod(sampler, uv, level)"},
            {"textureCube", "texture(sampler, direction)"},
            {"gl_FragColor", "an output of the fragment shader"},
            {"varying", "in or out"},
            {"attribute", "in"},
            // C and C++
            {"fabs", "abs"},
            {"hypot", "length(vec2(x, y))"},
            {"cbrt", "sign(x) * pow(abs(x), 1.0 / 3.0)"},
            {"fmin", "min"},
            {"fmax", "max"},
            {"M_PI", "3.14159265"},
            {"unsigned", "uint"},
            {"size_t", "int"},
            {"long", "int"},
            {"short", "int"},
            {"auto", "the name of a type, such as float"},
            {"constexpr", "const"},
            // WGSL, JavaScript and Python
            {"let", "the name of a type, such as float"},
            {"var", "the name of a type, such as float"},
            {"fn", "the type of the result, such as float"},
            {"def", "the type of the result, such as float"},
            {"function", "the type of the result, such as float"},
            {"and", "&&"},
            {"or", "||"},
            {"elif", "else if"},
            {"True", "true"},
            {"False", "false"},
            {"PI", "3.14159265"},
            {"norm", "length"},
            {"magnitude", "length"},
            {"Vector2", "vec2"},
            {"Vector3", "vec3"},
            {"Vector4", "vec4"},
        };
        for (const char* name :
             {"sin", "cos", "tan", "asin", "acos", "sqrt", "pow", "exp", "log", "floor", "ceil", "round"})
            all[std::string(name) + "f"] = name;
        for (const std::string size : {"2", "3", "4"}) {
            for (const char* real : {"float", "half", "fixed"}) all[real + size] = "vec" + size;
            all["double" + size] = "dvec" + size;
            all["int" + size] = "ivec" + size;
            all["uint" + size] = "uvec" + size;
            all["bool" + size] = "bvec" + size;
            all["vec" + size + "f"] = "vec" + size;
            all["vec" + size + "i"] = "ivec" + size;
            all["Vec" + size] = "vec" + size;
            all["float" + size + "x" + size] = "mat" + size + ", whose first index is a column";
        }
        return all;
    }();
    return words;
}

}  // namespace

const std::set<std::string>& built_in_functions() {
    static const std::set<std::string> names = set_of(
        "abs acos acosh all any asin asinh atan atanh bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil "
        "clamp cos cosh cross dFdx dFdy degrees determinant distance dot equal exp exp2 faceforward findLSB findMSB "
        "floatBitsToInt floatBitsToUint floor fma fract frexp fwidth greaterThan greaterThanEqual imulExtended "
        "intBitsToFloat interpolateAtCentroid interpolateAtOffset interpolateAtSample inverse inversesqrt isinf isnan "
        "ldexp length lessThan lessThanEqual log log2 matrixCompMult max min mix mod modf normalize not notEqual "
        "outerProduct packDouble2x32 packSnorm4x8 packUnorm2x16 packUnorm4x8 pow radians reflect refract round "
        "roundEven sign sin sinh smoothstep sqrt step tan tanh texelFetch texelFetchOffset texture textureGather "
        "textureGatherOffset textureGatherOffsets textureGrad textureGradOffset textureLod textureLodOffset "
        "textureOffset textureProj textureProjGrad textureProjGradOffset textureProjLod textureProjLodOffset "
        "textureProjOffset textureQueryLod textureSize transpose trunc uaddCarry uintBitsToFloat umulExtended "
        "unpackDouble2x32 unpackUnorm2x16 unpackUnorm4x8 unpackSnorm4x8 usubBorrow");
    return names;
}

bool is_glsl_keyword(const std::string& word) {
    static const std::set<std::string> words = set_of(
        "attribute const uniform varying layout centroid flat smooth noperspective patch sample subroutine in out "
        "inout "
        "invariant precise break continue do for while switch case default if else discard return struct void bool int "
        "uint float double vec2 vec3 vec4 dvec2 dvec3 dvec4 bvec2 bvec3 bvec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 mat2 "
        "mat3 mat4 mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 dmat2 dmat3 dmat4 true false highp "
        "mediump lowp precision sampler1D sampler2D sampler3D samplerCube sampler2DShadow sampler2DArray isampler2D "
        "usampler2D samplerCubeShadow sampler2DArrayShadow samplerBuffer sampler2DRect sampler2DMS");
    return words.contains(word);
}

std::string glsl_for(const std::string& word) {
    const auto found = foreign_words().find(word);
    return found == foreign_words().end() ? "" : found->second;
}

}  // namespace relief
