// The mosaic: Voronoi polygons of the sites in a triangle's own plane. Borders after I. Quilez,
// "Voronoi borders".

// For each triangle: first site, number of sites, bits of the scale, 0. Rows of 2048.
@group(2) @binding(0) var heads: texture_2d<u32>;
// Each site: place now, place before, cell, type. Rows of 2048.
@group(2) @binding(1) var sites: texture_2d<u32>;

// Half the width of a border, as a share of the mean spacing of the cells.
const BORDER_SHARE = 0.032;

struct Mosaic {
    colour: vec3f,
    // Slope of the surface towards a near border, in the triangle's plane.
    slope: vec2f,
}

struct Site {
    // From the fragment, in units of the list's scale.
    offset: vec2f,
    distance2: f32,
    cell: u32,
    kind: u32,
}

fn unpack(word: u32) -> vec2f {
    return vec2f(f32(word & 0xffffu), f32(word >> 16u));
}

// A number from 0 to 1 that belongs to the cell (the finaliser of MurmurHash3).
fn chance(cell: u32) -> f32 {
    var h = cell * 0x9e3779b1u + 0x7f4a7c15u;
    h = (h ^ (h >> 16u)) * 0x85ebca6bu;
    h = (h ^ (h >> 13u)) * 0xc2b2ae35u;
    return f32((h ^ (h >> 16u)) & 0xffffu) / 65535.0;
}

fn cell_colour(site: Site) -> vec3f {
    let lightness = 1.0 + scene.look.x * (2.0 * chance(site.cell) - 1.0);
    return scene.cells[site.kind].rgb * lightness * lightness;
}

// `place` in the plane of the triangle, with its derivatives along x and y of the screen.
fn mosaic(triangle: u32, place: vec2f, place_dx: vec2f, place_dy: vec2f) -> Mosaic {
    let head = textureLoad(heads, vec2u(triangle & 2047u, triangle >> 11u), 0);
    if head.y == 0u {
        return Mosaic(scene.cells[1].rgb, vec2f(0.0));
    }
    let scale = bitcast<f32>(head.z);
    let here = place / scale + 32768.0;
    let spacing = scene.tissue.x;
    let pixel = max(length(place_dx), length(place_dy));
    // 1: cells are seen one by one; 0: they are smaller than a pixel and a half.
    let apart = smoothstep(1.2, 3.0, spacing / pixel);
    let mean_radius = max(1.3 * spacing, pixel) / scale;
    let per_radius2 = 1.0 / (mean_radius * mean_radius);

    var first = Site(vec2f(0.0), 1e30, 0u, 1u);
    var second = first;
    var third = first;
    var shares = vec3f(0.0);
    for (var i = head.x; i < head.x + head.y; i++) {
        let word = textureLoad(sites, vec2u(i & 2047u, i >> 11u), 0);
        let offset = mix(unpack(word.y), unpack(word.x), scene.eye.w) - here;
        let site = Site(offset, dot(offset, offset), word.z, word.w & 3u);
        if site.distance2 < first.distance2 {
            third = second;
            second = first;
            first = site;
        } else if site.distance2 < second.distance2 {
            third = second;
            second = site;
        } else if site.distance2 < third.distance2 {
            third = site;
        }
        if apart < 1.0 {
            let near = max(1.0 - site.distance2 * per_radius2, 0.0);
            shares += near * near * vec3f(vec3u(site.kind) == vec3u(0u, 1u, 2u));
        }
    }

    var colour = cell_colour(first);
    var line = 0.0;
    var slope = vec2f(0.0);
    let half_line = BORDER_SHARE * spacing;
    for (var k = 0u; k < 2u; k++) {
        var other = second;
        if k == 1u {
            other = third;
        }
        if other.distance2 > 1e29 {
            break;
        }
        let between = (other.offset - first.offset) * scale;
        let apart_cm = length(between);
        let across = between / max(apart_cm, 1e-9);
        let to_border = dot(0.5 * scale * (first.offset + other.offset), across);
        // Width of the pixel across this border.
        let width = max(length(vec2f(dot(across, place_dx), dot(across, place_dy))), 1e-9);
        // A newborn cell stands where its parent stands: its border comes as they part.
        let parted = smoothstep(0.0, 0.3, apart_cm / spacing);
        let own = clamp(0.5 + to_border / width, 0.0, 1.0);
        colour = mix(cell_colour(other), colour, mix(1.0, own, parted));
        let drawn = max(half_line, 0.5 * width);
        let cover = clamp(0.5 + (drawn - to_border) / width, 0.0, 1.0) * half_line / drawn;
        line = max(line, cover * parted);
        let steep = to_border / (2.5 * half_line);
        slope += across * (parted * exp(-steep * steep));
    }
    // Cells are a little domed, where they are large enough to see it.
    slope *= 0.22 * smoothstep(8.0, 24.0, spacing / pixel);

    let border = scene.look.y * (2.0 - scene.look.y);
    if apart < 1.0 {
        let total = shares.x + shares.y + shares.z;
        if total > 0.0 {
            let mean = (shares.x * scene.cells[0].rgb + shares.y * scene.cells[1].rgb
                + shares.z * scene.cells[2].rgb) / total;
            colour = mix(mean, colour, apart);
            // The share of a regular mosaic's area that its borders take.
            line = mix(4.0 * BORDER_SHARE, line, apart);
        }
    }
    return Mosaic(colour * (1.0 - border * line), slope);
}
