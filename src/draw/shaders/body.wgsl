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

// The slope of a skin that is not quite even: waves in space, twice as long as a cell is wide and longer,
// where they are wide enough to be seen.
fn unevenness(world: vec3f, pixel: f32) -> vec3f {
    let scale = 2.2 / scene.tissue.x;
    let fade = scene.skin.y * (1.0 - smoothstep(0.15, 0.35, pixel * scale));
    if fade <= 0.0 {
        return vec3f(0.0);
    }
    let place = world * scale;
    return fade * (cos(place.yzx * 0.61 + 1.7 * sin(place.zxy * 0.37))
        + cos(place.zxy * 1.3 + 2.3 * sin(place * 0.53)));
}

// What a leaf lets through is more yellow than what it sends back.
fn passed(colour: vec3f) -> vec3f {
    return vec3f(max(colour.r, 0.6 * colour.g), colour.g, 0.3 * colour.b) * (1.2 * scene.tissue.z);
}

// The surface of a fragment without pattern. What is not thin is not seen from behind at its outline,
// where rounded normals look away from the eye.
fn surface_of(in: Fragment, front: bool, is_thin: bool, colour: vec3f, gloss: f32) -> Surface {
    let outward = normalize(in.normal.xyz);
    let away = in.world - scene.eye.xyz;
    let is_front = front || (!is_thin && dot(outward, away) < 0.3 * length(away));
    let open = vec2f(in.normal.w, in.bent.w);
    return Surface(in.world, select(-outward, outward, is_front), colour, gloss,
                   select(open.yx, open, is_front), normalize(select(-outward, in.bent.xyz, is_front)),
                   vec3f(0.0));
}

@fragment
fn fs_body(in: Fragment, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let world_dx = dpdx(in.world);
    let world_dy = dpdy(in.world);
    let place_dx = dpdx(in.plane);
    let place_dy = dpdy(in.plane);
    let uv_dx = dpdx(in.uv);
    let uv_dy = dpdy(in.uv);
    var surface = surface_of(in, front, scene.tissue.z > 0.0, vec3f(0.0), 0.0);
    if scene.diagram.x + scene.diagram.y > 0.0 {
        // Matt, so that colours can be read.
        surface.colour = triangle_colour(in.number);
        if scene.diagram.y > 0.0 {
            surface.colour = layers_colour(in.world, world_dx, world_dy, in.uv, uv_dx, uv_dy);
        }
        return to_screen(shade(surface), in.clip);
    }
    let tiles = mosaic(in.number, in.plane, place_dx, place_dy);
    var colour = tiles.colour.rgb;
    let normal = surface.normal;
    var clear = 1.0;
    let plane = gradients(normal, world_dx, world_dy, place_dx, place_dy);
    var bend = plane.x * tiles.slope.x + plane.y * tiles.slope.y;

    if scene.look.w > 0.5 {
        let vein = veins(in.uv, uv_dx, uv_dy);
        let pale = mix(colour, vec3f(0.62, 0.66, 0.28), 0.75);
        colour = mix(colour, pale, clamp(0.62 * vein.midrib + 0.26 * vein.side, 0.0, 1.0));
        let leaf = gradients(normal, world_dx, world_dy, uv_dx, uv_dy);
        // Sunken above, raised below.
        let depth_cm = select(-0.03, 0.05, front);
        clear -= 0.45 * max(vein.midrib, vein.side);
        bend += depth_cm * (leaf.x * vein.slope.x + leaf.y * vein.slope.y);
    }
    // A leaf is paler and duller below.
    let below = scene.tissue.z * select(1.0, 0.0, front);
    let grey = dot(colour, vec3f(0.25, 0.65, 0.10));
    surface.through = passed(colour) * clear;
    colour = mix(colour, mix(colour, vec3f(grey), 0.25) * 1.1 + 0.01, below);
    bend += unevenness(in.world, max(length(world_dx), length(world_dy)));
    surface.normal = normalize(normal + bend);
    // The thicker the wax is on the way to the eye, the paler and the duller.
    var wax = scene.skin.x;
    if wax > 0.0 {
        let n_view = max(dot(surface.normal, normalize(scene.eye.xyz - in.world)), 0.1);
        wax = 1.0 - exp(-wax / n_view);
    }
    surface.colour = mix(colour, vec3f(0.52, 0.60, 0.56), wax);
    surface.gloss = scene.look.z * tiles.colour.w * (1.0 - 0.5 * below) * (1.0 - wax);
    return to_screen(shade(surface), in.clip);
}

@fragment
fn fs_bare(in: Fragment, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    let material = scene.bare[in.number];
    let surface = surface_of(in, front, false, material.rgb, material.w);
    return to_screen(shade(surface), in.clip);
}
