// What all shaders share: the scene of a frame, the light of the studio, and the way to the screen.
// Lengths are centimetres, colours linear light.

struct Scene {
    view_projection: mat4x4f,
    // World to the clip space of the shadow map.
    light_projection: mat4x4f,
    // w: moment between the day before (0) and the shown day (1).
    eye: vec4f,
    // Towards the key light. w: edge of a shadow texel.
    key: vec4f,
    // Colours of F, B and M cells: square roots of linear light, which are even to the eye.
    cells: array<vec4f, 3>,
    // The same where a control image tints them.
    tinted: array<vec4f, 3>,
    // Variation of lightness, darkness of borders, gloss, veins (0 or 1).
    look: vec4f,
    // Mean spacing of the cells, slope of the side veins in leaf coordinates, sheet (0 or 1), dark
    // stage (0 or 1).
    tissue: vec4f,
    // Centre on the ground, and radius of the ground disc.
    ground: vec4f,
    // What covers the surface in place of the mosaic: colours of triangles (0 or 1), number of
    // layers. Width and height of the canvas in pixels.
    diagram: vec4f,
    // Colour of a diagram's lines, and the share of a line that is an arrow's head.
    ink: vec4f,
    // Colours of the bare materials. w: gloss.
    bare: array<vec4f, 16>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(1) @binding(0) var shadow_map: texture_depth_2d;
@group(1) @binding(1) var shadow_sampler: sampler_comparison;

struct Corner {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    // Share of the sky that the corner sees.
    @location(2) openness: f32,
    @location(3) uv: vec2f,
    // Place in the plane of the triangle, from its centroid.
    @location(4) plane: vec2f,
    // The triangle's number; in a bare part its material's.
    @location(5) number: u32,
}

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) world: vec3f,
    @location(1) normal: vec3f,
    @location(2) openness: f32,
    @location(3) uv: vec2f,
    @location(4) plane: vec2f,
    @location(5) @interpolate(flat, either) number: u32,
}

@vertex
fn vs_body(corner: Corner) -> Fragment {
    let clip = scene.view_projection * vec4f(corner.position, 1.0);
    return Fragment(clip, corner.position, corner.normal, corner.openness, corner.uv,
                    corner.plane, corner.number);
}

@vertex
fn vs_shadow(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return scene.light_projection * vec4f(position, 1.0);
}

struct Surface {
    world: vec3f,
    // Unit normal of the side that is seen.
    normal: vec3f,
    colour: vec3f,
    // 0 matt to 1 waxy.
    gloss: f32,
    openness: f32,
    // Share of the light on the far side that comes through.
    translucency: f32,
}

const KEY = vec3f(1.06, 1.00, 0.91);
const SKY = vec3f(0.37, 0.40, 0.45);
const SOIL = vec3f(0.28, 0.265, 0.24);
const DARK_SOIL = vec3f(0.15, 0.145, 0.14);
const FILL = vec3f(0.15, 0.155, 0.165);

// Share of the key light that reaches a point: nine comparisons, each already a blend of four
// texels, spread so that their tents just overlap and the edge of the shadow is smooth.
fn key_visibility(point: vec3f) -> f32 {
    let clip = (scene.light_projection * vec4f(point, 1.0)).xyz;
    let middle = clip.xy * vec2f(0.5, -0.5) + 0.5;
    let step = 1.9 / vec2f(textureDimensions(shadow_map));
    var sum = 0.0;
    for (var y = -1.0; y < 1.5; y += 1.0) {
        for (var x = -1.0; x < 1.5; x += 1.0) {
            sum += textureSampleCompareLevel(shadow_map, shadow_sampler,
                                             middle + vec2f(x, y) * step, clip.z);
        }
    }
    return sum / 9.0;
}

// Specular reflection of a lamp: the GGX distribution with Schlick's visibility and Fresnel terms
// (Karis, Real Shading in Unreal Engine 4).
fn glint(normal: vec3f, view: vec3f, lamp: vec3f, roughness: f32) -> f32 {
    let half_way = normalize(view + lamp);
    let n_h = max(dot(normal, half_way), 0.0);
    let n_v = max(dot(normal, view), 0.02);
    let n_l = max(dot(normal, lamp), 0.0);
    let a = roughness * roughness;
    let a2 = a * a;
    let denominator = n_h * n_h * (a2 - 1.0) + 1.0;
    let spread = a2 / (3.1416 * denominator * denominator);
    let k = (roughness + 1.0) * (roughness + 1.0) / 8.0;
    let hidden = 4.0 * (n_v * (1.0 - k) + k) * (n_l * (1.0 - k) + k);
    return spread * fresnel(max(dot(view, half_way), 0.0), 1.0) / hidden * n_l;
}

// Share of the light that is mirrored, from straight on to grazing, where it is `most`.
fn fresnel(cosine: f32, most: f32) -> f32 {
    let off = 1.0 - cosine;
    let off2 = off * off;
    return 0.04 + (most - 0.04) * off2 * off2 * off;
}

// Share of the light from all around that comes to a surface, with what its surroundings, taken to be of
// its own colour, pass on to it (Jimenez and others, Practical Real-Time Strategies for Accurate Indirect
// Occlusion, SIGGRAPH 2016 courses, equation 14).
fn around(surface: Surface) -> vec3f {
    let open = vec3f(surface.openness);
    let cubic = 2.0404 * surface.colour - 0.3324;
    let square = 0.6417 - 4.7951 * surface.colour;
    let linear = 2.7552 * surface.colour + 0.6903;
    return max(open, ((open * cubic + square) * open + linear) * open);
}

// The light that a surface sends to the eye.
fn shade(surface: Surface) -> vec3f {
    let normal = surface.normal;
    let view = normalize(scene.eye.xyz - surface.world);
    let key = scene.key.xyz;
    let n_key = dot(normal, key);
    // The point is lifted off its own shadow to the side on which the light falls: one texel
    // where it falls straight on, three where it grazes the surface.
    let lift = scene.key.w * (1.0 + 2.0 * (1.0 - abs(n_key)));
    var lit = 0.0;
    if n_key > 0.0 || surface.translucency > 0.0 {
        lit = key_visibility(surface.world + normal * select(-lift, lift, n_key > 0.0));
    }

    let through = surface.translucency * max(-n_key, 0.0);
    // A lamp beside the eye that reaches a little around the edge.
    let fill_lamp = normalize(view + vec3f(0.0, 0.35, 0.0));
    let fill = max(dot(normal, fill_lamp) + 0.3, 0.0) / 1.3;
    let soil = mix(SOIL, DARK_SOIL, scene.tissue.w);
    let ambient = mix(soil, SKY, 0.5 + 0.5 * normal.y);
    let diffuse = surface.colour * (KEY * lit * max(n_key, 0.0) + (ambient + FILL * fill) * around(surface))
        + surface.colour * sqrt(surface.colour) * KEY * lit * through;

    let roughness = mix(0.78, 0.14, surface.gloss);
    let mirrored = reflect(-view, normal);
    // The studio as the surface mirrors it: sky over soil, and a wide soft box around the key lamp.
    let horizon = smoothstep(-0.3 - 0.5 * roughness, 0.3 + 0.5 * roughness, mirrored.y);
    let box_edge = 0.25 * roughness;
    let soft_box = smoothstep(0.89 - box_edge, 0.93 + box_edge, dot(mirrored, key));
    let studio = mix(soil, SKY, horizon) + KEY * (0.6 * soft_box * lit);
    let grazing = fresnel(max(dot(normal, view), 0.0), max(1.0 - roughness, 0.04));
    let mirror = studio * grazing * surface.openness * mix(0.3, 0.9, surface.gloss);
    let lamp = KEY * (glint(normal, view, key, roughness) * lit);
    return diffuse + mirror + lamp;
}

// A gentle shoulder: leaves colours alone up to 0.7 and bends what is brighter towards white.
fn tone(light: vec3f) -> vec3f {
    let over = max(light - 0.7, vec3f(0.0));
    return min(light, vec3f(0.7)) + 0.3 * (1.0 - exp(over / -0.3));
}

// Half a step of noise against bands.
fn dither(clip: vec2f) -> f32 {
    return (fract(52.9829189 * fract(dot(clip, vec2f(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

// Linear light to the sRGB numbers of the canvas.
fn to_screen(light: vec3f, clip: vec4f) -> vec4f {
    let toned = tone(light);
    let srgb = select(1.055 * pow(toned, vec3f(1.0 / 2.4)) - 0.055, 12.92 * toned,
                      toned < vec3f(0.0031308));
    return vec4f(srgb + dither(clip.xy), 1.0);
}
