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

struct Near {
    // From the fragment, in units of the list's scale.
    offset: vec2f,
    distance2: f32,
    site: u32,
}

struct Cell {
    number: u32,
    colour: vec3f,
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

fn read_site(site: u32) -> vec4u {
    return textureLoad(sites, vec2u(site & 2047u, site >> 11u), 0);
}

fn read_cell(site: u32) -> Cell {
    let words = read_site(site);
    let lightness = 1.0 + scene.look.x * (2.0 * chance(words.z) - 1.0);
    return Cell(words.z, scene.cells[words.w & 3u].rgb * lightness * lightness);
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

    var first = Near(vec2f(0.0), 1e30, 0u);
    var second = first;
    var third = first;
    var shares = vec3f(0.0);
    for (var i = head.x; i < head.x + head.y; i++) {
        let words = read_site(i);
        let offset = mix(unpack(words.y), unpack(words.x), scene.eye.w) - here;
        let near = Near(offset, dot(offset, offset), i);
        if near.distance2 < third.distance2 {
            if near.distance2 < second.distance2 {
                third = second;
                if near.distance2 < first.distance2 {
                    second = first;
                    first = near;
                } else {
                    second = near;
                }
            } else {
                third = near;
            }
        }
        if apart < 1.0 {
            let weight = max(1.0 - near.distance2 * per_radius2, 0.0);
            shares += weight * weight * vec3f(vec3u(words.w & 3u) == vec3u(0u, 1u, 2u));
        }
    }

    let own = read_cell(first.site);
    var colour = own.colour;
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
        // A newborn cell stands where its parent stands: its border and its colour come as they part.
        let parted = smoothstep(0.0, 0.3, apart_cm / spacing);
        let neighbour = read_cell(other.site);
        if neighbour.number == own.number {
            // Its other image, seen on the far side of a curved vertex: no border.
            continue;
        }
        var kept = mix(1.0, clamp(0.5 + to_border / width, 0.0, 1.0), parted);
        if neighbour.number < own.number && parted < 1.0 {
            kept = max(parted, scene.eye.w);
        }
        colour = mix(neighbour.colour, colour, kept);
        let drawn = max(half_line, 0.5 * width);
        let cover = clamp(0.5 + (drawn - to_border) / width, 0.0, 1.0) * half_line / drawn;
        line = max(line, cover * parted);
        let steep = to_border / (1.7 * half_line);
        slope += across * (parted * exp(-steep * steep));
    }
    // Cells are a little domed, where they are large enough to see it.
    slope *= 0.16 * smoothstep(8.0, 24.0, spacing / pixel);

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
