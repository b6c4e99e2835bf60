// The patterned surface and the bare parts.

// How quickly the two coordinates of a plane change over the surface: their gradients in space.
struct Gradients {
    x: vec3f,
    y: vec3f,
}

fn gradients(normal: vec3f, world_dx: vec3f, world_dy: vec3f, c_dx: vec2f, c_dy: vec2f) -> Gradients {
    let along_x = cross(world_dy, normal);
    let along_y = cross(normal, world_dx);
    let area = dot(world_dx, along_x);
    let per_area = select(1.0 / area, 0.0, abs(area) < 1e-12);
    return Gradients((along_x * c_dx.x + along_y * c_dy.x) * per_area,
                     (along_x * c_dx.y + along_y * c_dy.y) * per_area);
}

struct Veins {
    // How much of the midrib and of a side vein is here, 0 to 1.
    midrib: f32,
    side: f32,
    // Change of their height along the two leaf coordinates.
    slope: vec2f,
}

// A ridge of half width 1: its height, and how that changes; flat on top, with soft flanks.
fn ridge(x: f32) -> vec2f {
    let height = exp(-x * x * x * x);
    return vec2f(height, -4.0 * x * x * x * height);
}

// A midrib and side veins that leave it in pairs and bend towards the tip. Where they are thinner
// than a pixel they are widened to it, and fainter.
fn veins(uv: vec2f, uv_dx: vec2f, uv_dy: vec2f) -> Veins {
    let x = abs(uv.x);
    let side_of = sign(uv.x);
    let mid_width = 0.05 * (1.0 - 0.6 * uv.y);
    let mid_drawn = max(mid_width, 0.7 * length(vec2f(uv_dx.x, uv_dy.x)));
    let midrib = ridge(uv.x / mid_drawn) * mid_width / mid_drawn;

    const PAIRS = 12.0;
    let lean = scene.tissue.y;
    let phase = PAIRS * (uv.y - lean * (x + 0.35 * x * x)) + 0.2 * side_of;
    let phase_change = PAIRS * vec2f(-lean * (1.0 + 0.7 * x) * side_of, 1.0);
    let pixel = length(vec2f(dot(phase_change, uv_dx), dot(phase_change, uv_dy)));
    let side_width = 0.05 * (1.0 - 0.75 * x);
    let side_drawn = max(side_width, 0.7 * pixel);
    // They end before rim, foot and tip, and where they would run into each other on the screen.
    let ends = smoothstep(0.0, 0.5, phase) * (1.0 - smoothstep(0.85, 1.0, x))
        * (1.0 - smoothstep(0.85, 0.97, uv.y)) * (1.0 - smoothstep(0.15, 0.35, pixel));
    let side = ridge((fract(phase) - 0.5) / side_drawn) * ends * side_width / side_drawn;

    let slope = vec2f(midrib.y / mid_drawn, 0.0) + 0.3 * phase_change * side.y / side_drawn;
    return Veins(midrib.x, side.x, slope);
}

@fragment
fn fs_body(in: Fragment, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let world_dx = dpdx(in.world);
    let world_dy = dpdy(in.world);
    let place_dx = dpdx(in.plane);
    let place_dy = dpdy(in.plane);
    let uv_dx = dpdx(in.uv);
    let uv_dy = dpdy(in.uv);
    let outward = normalize(in.normal);
    var normal = select(-outward, outward, front);

    if scene.diagram.x + scene.diagram.y > 0.0 {
        var covering = triangle_colour(in.number);
        if scene.diagram.y > 0.0 {
            covering = layers_colour(in.world, world_dx, world_dy, in.uv, uv_dx, uv_dy);
        }
        // Matt, so that colours can be read.
        let light = shade(Surface(in.world, normal, covering, 0.0, in.openness, 0.0));
        return to_screen(light, in.clip);
    }
    let tiles = mosaic(in.number, in.plane, place_dx, place_dy);
    var colour = tiles.colour;
    let plane = gradients(normal, world_dx, world_dy, place_dx, place_dy);
    var bend = plane.x * tiles.slope.x + plane.y * tiles.slope.y;

    if scene.look.w > 0.5 {
        let vein = veins(in.uv, uv_dx, uv_dy);
        let pale = mix(colour, vec3f(0.62, 0.66, 0.28), 0.75);
        colour = mix(colour, pale, clamp(0.62 * vein.midrib + 0.26 * vein.side, 0.0, 1.0));
        let leaf = gradients(normal, world_dx, world_dy, uv_dx, uv_dy);
        // Sunken above, raised below.
        let depth_cm = select(-0.03, 0.05, front);
        bend += depth_cm * (leaf.x * vein.slope.x + leaf.y * vein.slope.y);
    }
    // A leaf is paler and duller below.
    let below = scene.tissue.z * select(1.0, 0.0, front);
    let grey = dot(colour, vec3f(0.25, 0.65, 0.10));
    colour = mix(colour, mix(colour, vec3f(grey), 0.25) * 1.1 + 0.01, below);
    normal = normalize(normal + bend);
    let gloss = scene.look.z * (1.0 - 0.5 * below);
    let light = shade(Surface(in.world, normal, colour, gloss, in.openness, 0.45 * scene.tissue.z));
    return to_screen(light, in.clip);
}

@fragment
fn fs_bare(in: Fragment, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let outward = normalize(in.normal);
    let normal = select(-outward, outward, front);
    let material = scene.bare[in.number];
    let light = shade(Surface(in.world, normal, material.rgb, material.w, in.openness, 0.0));
    return to_screen(light, in.clip);
}
