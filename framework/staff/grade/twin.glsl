// Functions that GLSL 4.10 lacks for doubles: angles, powers and logarithms, with relative errors of about 1e-15.
// Texture reads stay in single precision. Twins of task functions call these: see twin_text.h.

double relief_exp(double x) {
    if (!(x > -745.0lf)) return isnan(x) ? x : 0.0lf;
    if (x > 709.0lf) return double(exp(1000.0));
    double whole = round(x * 1.4426950408889634lf), rest = x - whole * 0.693147180369123816490lf;
    rest -= whole * 1.90821492927058770002e-10lf;
    double sum = 1.0lf;
    for (int i = 16; i > 0; --i) sum = 1.0lf + sum * rest / double(i);
    // Computed as two factors: some drivers lack ldexp() for doubles.
    float half_ = floor(float(whole) * 0.5);
    return sum * double(exp2(half_)) * double(exp2(float(whole) - half_));
}

double relief_log(double x) {
    if (!(x > 0.0lf) || isinf(x)) return double(log(float(x)));
    // Scales x into the range of single precision first.
    double shift = 0.0lf;
    while (x < 1e-30lf) x *= 1e30lf, shift -= 69.077552789821370520540lf;
    while (x > 1e30lf) x *= 1e-30lf, shift += 69.077552789821370520540lf;
    double guess = double(log(float(x)));
    for (int i = 0; i < 2; ++i) {
        double power = relief_exp(guess);
        guess += 2.0lf * (x - power) / (x + power);
    }
    return guess + shift;
}

// Returns the sine and cosine, after range reduction by whole quarter turns.
dvec2 relief_sin_cos(double x) {
    double quarters = round(x * 0.63661977236758134308lf);
    double rest = x - quarters * 1.5707963267948965580lf;
    rest -= quarters * 6.123233995736766036e-17lf;
    double square = rest * rest, s = 1.0lf, c = 1.0lf;
    for (int i = 20; i > 1; i -= 2) {
        c = 1.0lf - c * square / double(i * (i - 1));
        s = 1.0lf - s * square / double(i * (i + 1));
    }
    s *= rest;
    int quarter = int(quarters - 4.0lf * floor(quarters * 0.25lf));
    if (quarter == 1) return dvec2(c, -s);
    if (quarter == 2) return dvec2(-s, -c);
    if (quarter == 3) return dvec2(-c, s);
    return dvec2(s, c);
}

double relief_sin(double x) { return relief_sin_cos(x).x; }
double relief_cos(double x) { return relief_sin_cos(x).y; }
double relief_tan(double x) {
    dvec2 both = relief_sin_cos(x);
    return both.x / both.y;
}
double relief_atan(double y, double x) {
    double size = max(abs(x), abs(y));
    if (!(size > 0.0lf)) return 0.0lf;
    double guess = double(atan(float(y / size), float(x / size)));
    dvec2 both = relief_sin_cos(guess);
    double off = (y * both.y - x * both.x) / (x * both.y + y * both.x);
    return guess + off - off * off * off / 3.0lf;
}
double relief_atan(double slope) { return relief_atan(slope, 1.0lf); }
double relief_asin(double x) { return relief_atan(x, sqrt((1.0lf - x) * (1.0lf + x))); }
double relief_acos(double x) { return relief_atan(sqrt((1.0lf - x) * (1.0lf + x)), x); }
double relief_exp2(double x) { return relief_exp(x * 0.693147180559945309417lf); }
double relief_log2(double x) { return relief_log(x) * 1.4426950408889634074lf; }
double relief_pow(double x, double y) { return x == 0.0lf ? (y > 0.0lf ? 0.0lf : 1.0lf) : relief_exp(y * relief_log(x)); }
double relief_radians(double x) { return x * 0.017453292519943295769lf; }
double relief_degrees(double x) { return x * 57.295779513082320877lf; }

#define RELIEF_OF_VECTORS(name) \
    dvec2 name(dvec2 v) { return dvec2(name(v.x), name(v.y)); } \
    dvec3 name(dvec3 v) { return dvec3(name(v.xy), name(v.z)); } \
    dvec4 name(dvec4 v) { return dvec4(name(v.xyz), name(v.w)); }
RELIEF_OF_VECTORS(relief_exp)
RELIEF_OF_VECTORS(relief_log)
RELIEF_OF_VECTORS(relief_sin)
RELIEF_OF_VECTORS(relief_cos)
RELIEF_OF_VECTORS(relief_tan)
RELIEF_OF_VECTORS(relief_atan)
RELIEF_OF_VECTORS(relief_asin)
RELIEF_OF_VECTORS(relief_acos)
RELIEF_OF_VECTORS(relief_exp2)
RELIEF_OF_VECTORS(relief_log2)
RELIEF_OF_VECTORS(relief_radians)
RELIEF_OF_VECTORS(relief_degrees)
dvec2 relief_pow(dvec2 x, dvec2 y) { return dvec2(relief_pow(x.x, y.x), relief_pow(x.y, y.y)); }
dvec3 relief_pow(dvec3 x, dvec3 y) { return dvec3(relief_pow(x.xy, y.xy), relief_pow(x.z, y.z)); }

dvec4 relief_textureLod(sampler2D map, dvec2 uv, double level) { return dvec4(textureLod(map, vec2(uv), float(level))); }
double relief_texture(sampler2DShadow map, dvec3 place) { return double(texture(map, vec3(place))); }
// Derivatives and implicit mip levels exist only in the fragment stage.
#ifdef RELIEF_FRAGMENT_STAGE
dvec4 relief_texture(sampler2D map, dvec2 uv) { return dvec4(texture(map, vec2(uv))); }
dvec2 relief_dFdx(dvec2 v) { return dvec2(dFdx(vec2(v))); }
dvec2 relief_dFdy(dvec2 v) { return dvec2(dFdy(vec2(v))); }
dvec3 relief_dFdx(dvec3 v) { return dvec3(dFdx(vec3(v))); }
dvec3 relief_dFdy(dvec3 v) { return dvec3(dFdy(vec3(v))); }
#endif
dvec4 relief_textureGrad(sampler2D map, dvec2 uv, dvec2 dx, dvec2 dy) {
    return dvec4(textureGrad(map, vec2(uv), vec2(dx), vec2(dy)));
}
