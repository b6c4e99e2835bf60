// The mosaic: Voronoi polygons of the sites in a triangle's own plane. Borders after I. Quilez,
// "Voronoi borders".

// For each triangle: first site, number of sites, bits of the scale, 0. Rows of 2048.
@group(2) @binding(0) var heads: texture_2d<u32>;
// Two sites each, packed as `Site` in `mosaic/sites.rs` says. Rows of 2048.
@group(2) @binding(1) var sites: texture_2d<u32>;

// Half the width of a border, as a share of the mean spacing of the cells.
const BORDER_SHARE = 0.032;

// The rim of what is lit, on each side of it: at least so many mean spacings of the cells, and pixels.
const RIM_SHARE = 0.07;
const RIM_PIXELS = 2.0;

struct Mosaic {
    // w: gloss, as a share of the look's.
    colour: vec4f,
    // Slope of the surface towards a near border, in the triangle's plane.
    slope: vec2f,
}

struct Near {
    // From the fragment, in units of the list's scale.
    offset: vec2f,
    tag: u32,
}

fn unpack(words: vec2u, shift: u32) -> vec2f {
    return vec2f((words >> vec2u(shift)) & vec2u(0xfffu));
}

// Two sites that stand side by side, of which the first has an even number.
fn two_sites(number: u32) -> vec4u {
    let texel = number >> 1u;
    return textureLoad(sites, vec2u(texel & 2047u, texel >> 11u), 0);
}

fn offset_of(site: vec2u, here: vec2f) -> vec2f {
    return mix(unpack(site, 12u), unpack(site, 0u), scene.eye.w) - here;
}

fn tag_of(site: vec2u) -> u32 {
    return (site.x >> 24u) | ((site.y >> 24u) << 8u);
}

// The low bits of a key are the number of a site in its list, the high ones those of its squared
// distance, which order as it does: three sites are kept sorted by least and greatest alone.
const NUMBER = 1023u;
const NONE = 0xffffffffu;

fn key_of(site: vec2u, number: u32, here: vec2f) -> u32 {
    let offset = offset_of(site, here);
    return (bitcast<u32>(dot(offset, offset)) & ~NUMBER) | number;
}

fn sorted_in(nearest: vec3u, key: u32) -> vec3u {
    let second = max(nearest.x, key);
    return min(nearest, vec3u(key, second, max(nearest.y, second)));
}

fn near_of(first: u32, key: u32, here: vec2f) -> Near {
    let number = first + (key & NUMBER);
    let pair = two_sites(number);
    let site = select(pair.xy, pair.zw, (number & 1u) == 1u);
    return Near(offset_of(site, here), tag_of(site));
}

fn kind_of(tag: u32) -> u32 {
    return tag & 3u;
}

fn tint_of(tag: u32) -> f32 {
    return f32((tag >> 9u) & 7u) / 7.0;
}

// The colour of cells of a type. w: their gloss.
fn tinted(kind: u32, tint: f32) -> vec4f {
    let plain = scene.cells[kind];
    let colour = mix(plain.rgb, scene.tinted[kind].rgb, tint);
    return vec4f(colour * colour, plain.w);
}

// Whether a cell is lit, where some are and some are not.
fn is_lit(tag: u32) -> bool {
    return (tag >> 15u) == 1u;
}

fn colour_of(tag: u32) -> vec4f {
    let shade = select(f32(tag >> 12u), 2.0 * f32((tag >> 12u) & 7u), scene.skin.z > 0.0);
    let lightness = 1.0 + scene.look.x * (2.0 / 15.0 * shade - 1.0);
    var colour = tinted(kind_of(tag), tint_of(tag)) * vec4f(vec3f(lightness * lightness), 1.0);
    if scene.skin.w > 0.0 {
        let clan = scene.clans[(tag >> 12u) & 7u].rgb;
        colour = vec4f(clan * clan, 0.5);
    }
    if scene.skin.z > 0.0 && !is_lit(tag) {
        // As in an old photograph, and dark enough for what is lit to shine.
        let grey = dot(colour.rgb, vec3f(0.25, 0.65, 0.10));
        colour = vec4f(mix(vec3f(grey), colour.rgb, 0.12) * 0.3 + 0.03, 0.3);
    }
    return colour;
}

// Of two cells that stand on one spot, whether the first was born of the second.
fn is_child(tag: u32, other: u32) -> bool {
    // Newborn and number stand next to each other in a tag.
    return (tag & 4u) != 0u && ((other & 4u) == 0u || (tag & 0x1f8u) > (other & 0x1f8u));
}

// `place` in the plane of the triangle, with its derivatives along x and y of the screen.
fn mosaic(triangle: u32, place: vec2f, place_dx: vec2f, place_dy: vec2f) -> Mosaic {
    let head = textureLoad(heads, vec2u(triangle & 2047u, triangle >> 11u), 0);
    let count = min(head.y, NUMBER);
    if count == 0u {
        return Mosaic(tinted(1u, 0.0), vec2f(0.0));
    }
    let scale = bitcast<f32>(head.z);
    let here = place / scale + 2048.0;
    let spacing = scene.tissue.x;
    let pixel = max(length(place_dx), length(place_dy));
    // 1: cells are seen one by one; 0: they are smaller than a pixel and a half.
    let apart = smoothstep(1.2, 3.0, spacing / pixel);
    var colour = vec4f(0.0);
    var line = 0.0;
    var slope = vec2f(0.0);
    // The same of what stands higher than its neighbours, and the shade beside it.
    var bank = vec2f(0.0);
    var shade = 0.0;
    // Of the rim of what is lit.
    var rim = 0.0;
    if apart > 0.0 {
        var nearest = vec3u(NONE);
        for (var i = 0u; i < count; i += 2u) {
            let pair = two_sites(head.x + i);
            nearest = sorted_in(nearest, key_of(pair.xy, i, here));
            let other = select(NONE, key_of(pair.zw, i + 1u, here), i + 1u < count);
            nearest = sorted_in(nearest, other);
        }
        let first = near_of(head.x, nearest.x, here);
        colour = colour_of(first.tag);
        let half_line = BORDER_SHARE * spacing;
        // Small cells of two types run into each other; from a dozen pixels on they are polygons.
        let soft = 0.33 * spacing * (1.0 - smoothstep(10.0, 14.0, spacing / pixel));
        for (var k = 0u; k < 2u; k++) {
            let key = select(nearest.y, nearest.z, k == 1u);
            let other = near_of(head.x, key, here);
            if key == NONE || other.tag == first.tag {
                // Its other image, seen on the far side of a curved vertex: no border.
                continue;
            }
            let between = (other.offset - first.offset) * scale;
            let apart_cm = length(between);
            let across = between / max(apart_cm, 1e-9);
            let to_border = dot(0.5 * scale * (first.offset + other.offset), across);
            // Width of the pixel across this border.
            let width =
                max(length(vec2f(dot(across, place_dx), dot(across, place_dy))), 1e-9);
            // A newborn cell stands where its parent stands: its border and its colour come as they
            // part.
            let parted = smoothstep(0.0, 0.3, apart_cm / spacing);
            let is_alike = kind_of(first.tag) == kind_of(other.tag);
            let edge = max(width, select(soft, 0.0, is_alike));
            var kept = mix(1.0, clamp(0.5 + to_border / edge, 0.0, 1.0), parted);
            if parted < 1.0 && is_child(first.tag, other.tag) {
                kept = max(parted, scene.eye.w);
            }
            colour = mix(colour_of(other.tag), colour, kept);
            let drawn = max(half_line, 0.5 * width);
            let cover = clamp(0.5 + (drawn - to_border) / width, 0.0, 1.0) * half_line / drawn;
            line = max(line, cover * parted);
            let steep = to_border / (1.7 * half_line);
            slope += across * (parted * exp(-steep * steep));
            if scene.skin.z > 0.0 && is_lit(first.tag) != is_lit(other.tag) {
                let wide = max(RIM_SHARE * spacing, RIM_PIXELS * width);
                rim = max(rim, parted * clamp(0.5 + (wide - to_border) / width, 0.0, 1.0));
            }
            let step = scene.tinted[kind_of(first.tag)].w - scene.tinted[kind_of(other.tag)].w;
            if step != 0.0 {
                let near = parted * (1.0 - smoothstep(0.0, 0.5, to_border / spacing));
                bank += across * (max(step, 0.0) * near);
                shade = max(shade, -0.5 * step * near * near);
            }
        }
        // Cells are a little domed, where they are large enough to see it.
        slope *= 0.16 * smoothstep(8.0, 24.0, spacing / pixel);
        slope += bank * apart;
        line = max(line, shade * apart);
    }
    if apart < 1.0 {
        let mean_radius = max(1.3 * spacing, pixel) / scale;
        let per_radius2 = 1.0 / (mean_radius * mean_radius);
        var shares = vec3f(0.0);
        var tints = vec3f(0.0);
        var marked = vec4f(0.0);
        for (var i = 0u; i < count; i++) {
            let near = near_of(head.x, i, here);
            // All count a little: somewhere no site may be within the radius.
            let weight = max(1.0 - dot(near.offset, near.offset) * per_radius2, 1e-3);
            let share =
                weight * weight * vec3f(vec3u(kind_of(near.tag)) == vec3u(0u, 1u, 2u));
            shares += share;
            tints += share * tint_of(near.tag);
            if scene.skin.z > 0.0 {
                marked += weight * weight * colour_of(near.tag);
            }
        }
        let whole = shares.x + shares.y + shares.z;
        tints /= max(shares, vec3f(1e-9));
        var mean = (shares.x * tinted(0u, tints.x) + shares.y * tinted(1u, tints.y)
            + shares.z * tinted(2u, tints.z)) / whole;
        if scene.skin.z > 0.0 {
            mean = marked / whole;
        }
        colour = mix(mean, colour, apart);
        // The share of a regular mosaic's area that its borders take.
        line = mix(4.0 * BORDER_SHARE, line, apart);
    }
    let border = scene.look.y * (2.0 - scene.look.y);
    colour *= vec4f(vec3f(1.0 - border * line), 1.0);
    return Mosaic(mix(colour, vec4f(0.95, 0.93, 0.85, 0.0), rim), slope);
}
