// Diagrams: what covers the surface in place of the mosaic, and lines and arrows in space.

// As `draw/diagram.rs` packs them. Rows of 2048.
@group(2) @binding(2) var records: texture_2d<u32>;

fn record(number: u32) -> vec4u {
    return textureLoad(records, vec2u(number & 2047u, number >> 11u), 0);
}

// Four bytes, 0 to 1.
fn bytes(word: u32) -> vec4f {
    return vec4f((vec4u(word) >> vec4u(0u, 8u, 16u, 24u)) & vec4u(0xffu)) / 255.0;
}

// sRGB numbers to linear light, nearly.
fn triangle_colour(triangle: u32) -> vec3f {
    return pow(bytes(record(triangle >> 2u)[triangle & 3u]).rgb, vec3f(2.2));
}

// What the layers make of white at a place.
fn grey_at(world: vec3f, leaf: vec2f) -> f32 {
    var grey = 1.0;
    for (var k = 0u; k < u32(4.0 * scene.diagram.y); k += 4u) {
        let base = bitcast<vec4f>(record(k));
        let axis = bitcast<vec4f>(record(k + 1u));
        let zero = bitcast<vec4f>(record(k + 2u));
        let image = record(k + 3u);
        var place = vec2f(0.5 + 0.5 * leaf.x, leaf.y);
        if base.w > 0.0 {
            let out = world - base.xyz;
            let angle = atan2(dot(out, cross(axis.xyz, zero.xyz)), dot(out, zero.xyz));
            place = vec2f(fract(angle / 6.2831853), dot(out, axis.xyz) / base.w);
        }
        let size = vec2f(image.yz);
        let pixel = vec2u(clamp(place * size, vec2f(0.0), size - 0.5));
        let number = pixel.y * image.y + pixel.x;
        let white = bytes(record(image.x + (number >> 4u))[(number >> 2u) & 3u])[number & 3u];
        if abs(grey - axis.w) < 0.1 {
            grey = mix(zero.w, bitcast<f32>(image.w), white);
        }
    }
    return grey;
}

// The mean of nine places in a pixel of the screen.
fn layers_colour(world: vec3f, world_dx: vec3f, world_dy: vec3f, leaf: vec2f, leaf_dx: vec2f,
                 leaf_dy: vec2f) -> vec3f {
    var sum = 0.0;
    for (var y = -0.3; y < 0.5; y += 0.3) {
        for (var x = -0.3; x < 0.5; x += 0.3) {
            sum += grey_at(world + x * world_dx + y * world_dy, leaf + x * leaf_dx + y * leaf_dy);
        }
    }
    // Between a black and a white that still show their shading.
    return vec3f(mix(0.015, 0.8, sum / 9.0));
}

// A line of a little over a pixel and, if the ink has arrows, their heads at its end. Where arrows
// are shorter than a 50th of the picture, one in 32 is drawn, as much longer: the first of those into
// which two rounds of refinement cut a quad.
@vertex
fn vs_line(@builtin(vertex_index) corner: u32, @builtin(instance_index) number: u32,
           @location(0) start: vec3f, @location(1) end: vec3f) -> @builtin(position) vec4f {
    let view = scene.view_projection;
    let head = scene.ink.w;
    let upright = length(vec3f(view[0].y, view[1].y, view[2].y));
    let share = distance(start, end) * upright / (view * vec4f(scene.ground.xyz, 1.0)).w;
    let every = select(1u, 32u, head > 0.0 && share < 0.04);
    let half_way = (end - start) * select(0.0, 0.5 * sqrt(f32(every)), number % every == 0u);
    let middle = (start + end) * 0.5;
    let from_clip = lifted(middle - half_way);
    let to_clip = lifted(middle + half_way);
    let size = scene.diagram.zw;
    let way = (to_clip.xy / to_clip.w - from_clip.xy / from_clip.w) * size;
    // Two triangles, 0, 1, 2 and 1, 2, 3, and a third one for the head.
    let k = corner % 3u + corner / 3u;
    var along = select(0.0, 1.0 - head, k > 1u);
    var half_width = max(1.3, size.y / 700.0) / max(length(way), 1e-6);
    if corner > 5u {
        along = select(1.0 - head, 1.0, k == 4u);
        half_width = select(head * 0.45, 0.0, k == 4u);
    }
    let here = mix(from_clip, to_clip, along);
    let side = vec2f(-way.y, way.x) * select(-half_width, half_width, (k & 1u) == 1u);
    return here + vec4f(side * here.w / size, 0.0, 0.0);
}

// A point in clip space, two texels of the shadow map nearer to the eye: off the surface.
fn lifted(point: vec3f) -> vec4f {
    let to_eye = normalize(scene.eye.xyz - point) * (2.0 * scene.key.w);
    return scene.view_projection * vec4f(point + to_eye, 1.0);
}

@fragment
fn fs_line(@builtin(position) clip: vec4f) -> @location(0) vec4f {
    return to_screen(scene.ink.rgb, clip);
}
