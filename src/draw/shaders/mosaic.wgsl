// The mosaic: Voronoi polygons of the sites in a triangle's own plane. Borders after I. Quilez,
// "Voronoi borders".

// For each triangle: first site, number of sites, bits of the scale, 0. Rows of 2048.
@group(2) @binding(0) var heads: texture_2d<u32>;
// Two sites each, packed as `Site` in `mosaic/sites.rs` says. Rows of 2048.
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
    tag: u32,
}

fn unpack(words: vec2u, shift: u32) -> vec2f {
    return vec2f((words >> vec2u(shift)) & vec2u(0xfffu));
}

fn kind_of(tag: u32) -> u32 {
    return tag & 3u;
}

fn tint_of(tag: u32) -> f32 {
    return f32((tag >> 9u) & 7u) / 7.0;
}

// The colour of cells of a type.
fn tinted(kind: u32, tint: f32) -> vec3f {
    let colour = mix(scene.cells[kind].rgb, scene.tinted[kind].rgb, tint);
    return colour * colour;
}

fn colour_of(tag: u32) -> vec3f {
    let lightness = 1.0 + scene.look.x * (2.0 / 15.0 * f32(tag >> 12u) - 1.0);
    return tinted(kind_of(tag), tint_of(tag)) * lightness * lightness;
}

// Of two cells that stand on one spot, whether the first was born of the second.
fn is_child(tag: u32, other: u32) -> bool {
    // Newborn and number stand next to each other in a tag.
    return (tag & 4u) != 0u && ((other & 4u) == 0u || (tag & 0x1f8u) > (other & 0x1f8u));
}

// `place` in the plane of the triangle, with its derivatives along x and y of the screen.
fn mosaic(triangle: u32, place: vec2f, place_dx: vec2f, place_dy: vec2f) -> Mosaic {
    let head = textureLoad(heads, vec2u(triangle & 2047u, triangle >> 11u), 0);
    if head.y == 0u {
        return Mosaic(tinted(1u, 0.0), vec2f(0.0));
    }
    let scale = bitcast<f32>(head.z);
    let here = place / scale + 2048.0;
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
    var tints = vec3f(0.0);
    var pair = vec4u(0u);
    for (var i = 0u; i < head.y; i++) {
        if (i & 1u) == 0u {
            let texel = (head.x + i) >> 1u;
            pair = textureLoad(sites, vec2u(texel & 2047u, texel >> 11u), 0);
        } else {
            pair = pair.zwxy;
        }
        let tag = (pair.x >> 24u) | ((pair.y >> 24u) << 8u);
        let offset = mix(unpack(pair.xy, 12u), unpack(pair.xy, 0u), scene.eye.w) - here;
        let near = Near(offset, dot(offset, offset), tag);
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
            let share = weight * weight * vec3f(vec3u(kind_of(tag)) == vec3u(0u, 1u, 2u));
            shares += share;
            tints += share * tint_of(tag);
        }
    }

    var colour = colour_of(first.tag);
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
        if other.tag == first.tag {
            // Its other image, seen on the far side of a curved vertex: no border.
            continue;
        }
        var kept = mix(1.0, clamp(0.5 + to_border / width, 0.0, 1.0), parted);
        if parted < 1.0 && is_child(first.tag, other.tag) {
            kept = max(parted, scene.eye.w);
        }
        colour = mix(colour_of(other.tag), colour, kept);
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
            tints /= max(shares, vec3f(1e-9));
            let mean = (shares.x * tinted(0u, tints.x) + shares.y * tinted(1u, tints.y)
                + shares.z * tinted(2u, tints.z)) / total;
            colour = mix(mean, colour, apart);
            // The share of a regular mosaic's area that its borders take.
            line = mix(4.0 * BORDER_SHARE, line, apart);
        }
    }
    return Mosaic(colour * (1.0 - border * line), slope);
}
