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
    // Colours of F, B and M cells: square roots of linear light, which are even to the eye. w: their
    // gloss, as a share of the look's.
    cells: array<vec4f, 3>,
    // The same where a control image tints them. w: how high they stand above other types.
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
    // Wax that lies on the skin, and how uneven it is. Whether sites have marks in the place of lightness, and
    // whether those are colours of clans (0 or 1).
    skin: vec4f,
    // Square roots, too.
    clans: array<vec4f, 8>,
    // Colours of the bare materials. w: gloss.
    bare: array<vec4f, 16>,
}

@group(0) @binding(0) var<uniform> scene: Scene;
@group(1) @binding(0) var shadow_map: texture_depth_2d;
@group(1) @binding(1) var shadow_sampler: sampler_comparison;

struct Corner {
    @location(0) position: vec3f,
    // w: share of the sky that this side sees.
    @location(1) normal: vec4f,
    // Mean direction of the sky that this side sees. w: share that the other side sees.
    @location(2) bent: vec4f,
    @location(3) uv: vec2f,
    // Place in the plane of the triangle, from its centroid.
    @location(4) plane: vec2f,
    // The triangle's number; in a bare part its material's.
    @location(5) number: u32,
    // The same the day before, of a body that moves.
    @location(6) position_before: vec3f,
    @location(7) normal_before: vec4f,
}

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) world: vec3f,
    @location(1) normal: vec4f,
    @location(2) bent: vec4f,
    @location(3) uv: vec2f,
    @location(4) plane: vec2f,
    @location(5) @interpolate(flat, either) number: u32,
}

@vertex
fn vs_body(corner: Corner) -> Fragment {
    let moment = scene.eye.w;
    let world = standing(corner.position, corner.position_before);
    let turned = corner.normal_before.xyz + (corner.normal - corner.normal_before).xyz * moment;
    let clip = scene.view_projection * vec4f(world, 1.0);
    return Fragment(clip, world, vec4f(turned, corner.normal.w), corner.bent, corner.uv,
                    corner.plane, corner.number);
}

// Where a corner is between the day before and the day: not a bit elsewhere if it does not move.
fn standing(now: vec3f, before: vec3f) -> vec3f {
    return before + (now - before) * scene.eye.w;
}

@vertex
fn vs_shadow(@location(0) position: vec3f,
             @location(6) position_before: vec3f) -> @builtin(position) vec4f {
    return scene.light_projection * vec4f(standing(position, position_before), 1.0);
}

struct Surface {
    world: vec3f,
    // Unit normal of the side that is seen.
    normal: vec3f,
    colour: vec3f,
    // 0 matt to 1 waxy.
    gloss: f32,
    // Shares of the sky that this side and the other one see.
    open: vec2f,
    // Mean direction of the sky that this side sees.
    bent: vec3f,
    // Colour of the light that comes through from the other side, where that is so.
    through: vec3f,
}

// What is matt, faces the key light and sees the whole sky gets 1 of them together, so that it has its own
// colour on the screen.
const KEY = vec3f(0.645, 0.63, 0.60);
const SKY = vec3f(0.36, 0.38, 0.42);
const SOIL = vec3f(0.30, 0.26, 0.20);
const DARK_SOIL = vec3f(0.13, 0.12, 0.11);
// A lamp at the eye, and one behind the plant, which draws its rim.
const FILL = vec3f(0.05);
const RIM = vec3f(0.45, 0.46, 0.48);
const RIM_WAY = vec3f(0.42, 0.42, -0.80);
// To the right of whom the key lamp, and the rim lamp, looks at.
const KEY_RIGHT = vec3f(0.677, 0.0, 0.736);
const RIM_RIGHT = vec3f(-0.885, 0.0, -0.465);

// Share of the key light that reaches a point: comparisons in a square (`reach` 1: nine, 0.5: four), each
// already a blend of four texels, spread so that their tents just overlap and the edge of the shadow is smooth.
fn key_visibility(point: vec3f, reach: f32) -> f32 {
    let clip = (scene.light_projection * vec4f(point, 1.0)).xyz;
    let middle = clip.xy * vec2f(0.5, -0.5) + 0.5;
    let step = 1.9 / vec2f(textureDimensions(shadow_map));
    var sum = 0.0;
    for (var y = -reach; y < 1.5 * reach; y += 1.0) {
        for (var x = -reach; x < 1.5 * reach; x += 1.0) {
            sum += textureSampleCompareLevel(shadow_map, shadow_sampler,
                                             middle + vec2f(x, y) * step, clip.z);
        }
    }
    return sum / ((2.0 * reach + 1.0) * (2.0 * reach + 1.0));
}

// Share of the light from all around that comes to a surface, with what its surroundings, taken to be of
// its own colour, pass on to it (Jimenez and others, Practical Real-Time Strategies for Accurate Indirect
// Occlusion, SIGGRAPH 2016 courses, equation 14).
fn around(surface: Surface) -> vec3f {
    let open = vec3f(surface.open.x);
    let cubic = 2.0404 * surface.colour - 0.3324;
    let square = 0.6417 - 4.7951 * surface.colour;
    let linear = 2.7552 * surface.colour + 0.6903;
    return max(open, ((open * cubic + square) * open + linear) * open);
}

// Sky over soil; `spread`: half the height of the horizon between them.
fn studio(way: vec3f, spread: f32) -> vec3f {
    return mix(mix(SOIL, DARK_SOIL, scene.tissue.w), SKY, clamp(0.5 + 0.5 * way.y / spread, 0.0, 1.0));
}

// A window of four panes in the mirror of a surface: its middle, and half its width and height from one
// unit away.
fn window(way: vec3f, middle: vec3f, right: vec3f, half_size: vec2f, blur: f32) -> f32 {
    let ahead = dot(way, middle);
    if ahead < 0.1 {
        return 0.0;
    }
    let place = abs(vec2f(dot(way, right), dot(way, cross(middle, right)))) / ahead;
    let inside = 1.0 - smoothstep(half_size - blur, half_size + blur, place);
    let panes = smoothstep(vec2f(0.03 - blur), vec2f(0.03 + blur), place);
    let bars = mix(1.0, panes.x * panes.y, max(1.0 - 5.0 * blur, 0.0));
    return inside.x * inside.y * bars;
}

// Share of what surrounds a mirror that it sends on, as scale and bias of what it mirrors straight on (Karis,
// Physically Based Shading on Mobile).
fn mirrored_share(roughness: f32, n_view: f32) -> vec2f {
    let r = roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let a = min(r.x * r.x, exp2(-9.28 * n_view)) * r.x + r.y;
    return vec2f(-1.04, 1.04) * a + r.zw;
}

// The light that a surface sends to the eye.
fn shade(surface: Surface) -> vec3f {
    let normal = surface.normal;
    let view = normalize(scene.eye.xyz - surface.world);
    let n_view = clamp(dot(normal, view), 0.02, 1.0);
    let key = scene.key.xyz;
    let n_key = dot(normal, key);
    let is_leaf = surface.through.g > 0.0;
    // The point is lifted off its own shadow to the side on which the light falls: one texel
    // where it falls straight on, four where it grazes the surface.
    let lift = scene.key.w * (1.0 + 3.0 * (1.0 - abs(n_key)));
    var lit = 0.0;
    if n_key > 0.0 || is_leaf {
        lit = key_visibility(surface.world + normal * select(-lift, lift, n_key > 0.0), 1.0);
    }
    // Where light grazes flesh or clay it fades before the shadow map can show its grain, red the last.
    let spread = select(vec3f(0.05, 0.08, 0.11), vec3f(0.0), is_leaf);
    let facing = max((n_key - spread) / (1.0 - spread), vec3f(0.0));
    let rim = dot(normal, RIM_WAY);
    let light = KEY * lit * facing + (studio(normalize(surface.bent + normal), 1.0) + FILL * n_view
        + RIM * max(rim, 0.0)) * around(surface);

    // What falls on the other side of a leaf: most of the lamp's light goes straight on.
    let on = max(-dot(view, key), 0.0);
    let beyond = KEY * lit * max(-n_key, 0.0) * (0.9 + on * on)
        + (RIM * max(-rim, 0.0) + studio(-normal, 1.0)) * surface.open.y;

    // What bends within a pixel is rougher for it (Kaplanyan and others, Filtering Distributions of Normals
    // for Shading Antialiasing).
    let bend = fwidth(normal);
    // What is matt sends on as much of all its light, whatever its colour, as the tone takes off again.
    let least = min(surface.colour.r, min(surface.colour.g, surface.colour.b));
    let matt = light * select(0.04, 0.4 * sqrt(least) - least, least < 0.04);
    let diffuse = surface.colour * light + surface.through * beyond;
    if surface.gloss <= 0.0 {
        return diffuse + matt;
    }
    let rough = mix(0.75, 0.14, surface.gloss);
    let rough2 = rough * rough;
    let roughness = sqrt(sqrt(rough2 * rough2 + min(0.25 * dot(bend, bend), 0.18)));
    let way = reflect(-view, normal);
    let blur = 0.02 + 0.8 * roughness * roughness;
    // The free part of the mirrored light: a cone around the mean direction of the sky.
    let cone = sqrt(1.0 - min(surface.open.x, 1.0));
    let free = smoothstep(cone - 0.3 - 0.4 * roughness, cone + 0.2, dot(way, surface.bent));
    let seen = studio(way, 0.2 + 0.8 * roughness) * free
        + KEY * (6.0 * window(way, key, KEY_RIGHT, vec2f(0.34, 0.5), blur) * lit)
        + RIM * (3.0 * window(way, RIM_WAY, RIM_RIGHT, vec2f(0.8, 0.4), blur) * free);
    let share = mirrored_share(roughness, n_view);
    return diffuse + mix(matt, seen * (0.04 * share.x + share.y), smoothstep(0.0, 0.3, surface.gloss));
}

// Colours stay what they are, less 4 % that a white light adds by the mirror of every surface, and those
// that are too bright keep their hue (Khronos PBR Neutral).
fn tone(light: vec3f) -> vec3f {
    let least = min(light.r, min(light.g, light.b));
    let colour = light - select(0.04, least - 6.25 * least * least, least < 0.08);
    let peak = max(colour.r, max(colour.g, colour.b));
    if peak < 0.76 {
        return colour;
    }
    let bent_peak = 1.0 - 0.0576 / (peak - 0.52);
    return mix(vec3f(bent_peak), colour * (bent_peak / peak), 1.0 / (0.15 * (peak - bent_peak) + 1.0));
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
