// Diagrams: what covers the surface in place of the mosaic, and thin lines in space.

// As `draw/diagram.rs` packs them. Rows of 2048.
@group(2) @binding(2) var records: texture_2d<u32>;

fn record(number: u32) -> vec4u {
    return textureLoad(records, vec2u(number & 2047u, number >> 11u), 0);
}

fn byte(of: u32, number: u32) -> f32 {
    return f32((of >> (8u * number)) & 0xffu) / 255.0;
}

// sRGB numbers to linear light, nearly.
fn triangle_colour(triangle: u32) -> vec3f {
    let word = record(triangle >> 2u)[triangle & 3u];
    return pow(vec3f(byte(word, 0u), byte(word, 1u), byte(word, 2u)), vec3f(2.2));
}

// What the layers make of white at a place.
fn grey_at(world: vec3f, leaf: vec2f) -> f32 {
    var grey = 1.0;
    for (var k = 0u; k < u32(scene.diagram.y); k++) {
        let base = bitcast<vec4f>(record(4u * k));
        let axis = bitcast<vec4f>(record(4u * k + 1u));
        let zero = bitcast<vec4f>(record(4u * k + 2u));
        let image = record(4u * k + 3u);
        var place = vec2f(0.5 + 0.5 * leaf.x, leaf.y);
        if base.w > 0.0 {
            let out = world - base.xyz;
            let angle = atan2(dot(out, cross(axis.xyz, zero.xyz)), dot(out, zero.xyz));
            place = vec2f(fract(angle / 6.2831853), dot(out, axis.xyz) / base.w);
        }
        let size = vec2f(image.yz);
        let pixel = vec2u(clamp(place * size, vec2f(0.0), size - 0.5));
        let number = pixel.y * image.y + pixel.x;
        let white = byte(record(image.x + (number >> 4u))[(number >> 2u) & 3u], number & 3u);
        if abs(grey - axis.w) < 0.1 {
            grey = mix(zero.w, grey, white);
        }
    }
    return grey;
}

// The mean of nine places in a pixel of the screen.
fn layers_colour(world: vec3f, world_dx: vec3f, world_dy: vec3f, leaf: vec2f, leaf_dx: vec2f,
                 leaf_dy: vec2f) -> vec3f {
    var sum = 0.0;
    for (var y = -1.0; y < 1.5; y += 1.0) {
        for (var x = -1.0; x < 1.5; x += 1.0) {
            sum += grey_at(world + (x * world_dx + y * world_dy) / 3.0,
                           leaf + (x * leaf_dx + y * leaf_dy) / 3.0);
        }
    }
    // Between a black and a white that still show their shading.
    return vec3f(mix(0.015, 0.8, sum / 9.0));
}

// A line as a strip of two triangles, a little over a pixel wide, and lifted off the surface.
@vertex
fn vs_line(@builtin(vertex_index) corner: u32, @location(0) start: vec3f, @location(1) end: vec3f)
    -> @builtin(position) vec4f {
    let ends = array(lifted(start), lifted(end));
    let size = scene.diagram.zw;
    let along = (ends[1].xy / ends[1].w - ends[0].xy / ends[0].w) * size;
    let across = vec2f(-along.y, along.x) / max(length(along), 1e-6);
    // Corners 0, 1, 2 and 1, 2, 3 of the strip.
    let k = corner % 3u + corner / 3u;
    let here = select(ends[0], ends[1], k > 1u);
    let half_width_px = max(1.3, size.y / 700.0) * select(-0.5, 0.5, (k & 1u) == 1u);
    return here + vec4f(across * (2.0 * half_width_px * here.w) / size, 0.0, 0.0);
}

// A point in clip space, two texels of the shadow map nearer to the eye.
fn lifted(point: vec3f) -> vec4f {
    let to_eye = normalize(scene.eye.xyz - point) * (2.0 * scene.key.w);
    return scene.view_projection * vec4f(point + to_eye, 1.0);
}

@fragment
fn fs_line(@builtin(position) clip: vec4f) -> @location(0) vec4f {
    return to_screen(scene.ink.rgb, clip);
}
