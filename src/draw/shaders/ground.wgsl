// The shadow on the ground: a disc that is nothing but darkness, drawn over the stage of the page.
// On a dark stage a faint pool of light lies around it, so that there is something to darken.

struct GroundFragment {
    @builtin(position) clip: vec4f,
    // From the centre, in radii of the disc.
    @location(0) out: vec2f,
    // Shares of the sky and of the key light that the body takes away, and how near it is.
    @location(1) darkness: vec3f,
}

fn on_ground(out: vec2f) -> vec3f {
    return scene.ground.xyz + vec3f(out.x, 0.0, out.y) * scene.ground.w;
}

@vertex
fn vs_ground(@location(0) out: vec2f, @location(1) darkness: vec3f) -> GroundFragment {
    return GroundFragment(scene.view_projection * vec4f(on_ground(out), 1.0), out, darkness);
}

@fragment
fn fs_ground(in: GroundFragment) -> @location(0) vec4f {
    let fade = 1.0 - smoothstep(0.35, 1.0, length(in.out));
    let dark_stage = scene.tissue.w;
    // Sharp at the foot, soft where what casts it stands high.
    let near = smoothstep(0.15, 0.9, in.darkness.z);
    var lamp = in.darkness.y;
    if near * lamp > 0.004 {
        lamp = mix(lamp, 1.0 - key_visibility(on_ground(in.out), 0.5), near);
    }
    let contact = smoothstep(0.35, 0.75, in.darkness.x);
    let sky = mix(0.5, 0.75, dark_stage) * in.darkness.x * (1.0 + 0.5 * contact);
    let key = mix(0.26, 0.5, dark_stage) * lamp * (1.0 + 0.4 * near);
    let shadow = fade * (1.0 - (1.0 - sky) * (1.0 - key));
    let pool = dark_stage * 0.10 * fade * fade * (1.0 - shadow);
    // The floor is warm, and so is what it sends into its shadow.
    let warmth = vec3f(0.15, 0.115, 0.07) * (shadow * (1.0 - dark_stage));
    let noise = dither(in.clip.xy) * step(0.002, fade);
    return vec4f(max(pool + warmth + noise * dark_stage, vec3f(0.0)), max(shadow + noise, 0.0));
}

// A picture that was drawn before, over the whole target.
@group(0) @binding(0) var image: texture_2d<f32>;

@vertex
fn vs_whole(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(vec2u(corner & 1u, corner >> 1u)) * 4.0 - 1.0, 0.0, 1.0);
}

@fragment
fn fs_whole(@builtin(position) clip: vec4f) -> @location(0) vec4f {
    return textureLoad(image, vec2u(clip.xy), 0);
}
