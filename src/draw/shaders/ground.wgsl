// The shadow on the ground: a disc that is nothing but darkness, drawn over the stage of the page.
// On a dark stage a faint pool of light lies around it, so that there is something to darken.

struct GroundFragment {
    @builtin(position) clip: vec4f,
    // From the centre, in radii of the disc.
    @location(0) out: vec2f,
    // Share of the sky, and of the key light, that the body takes away.
    @location(1) darkness: vec2f,
}

@vertex
fn vs_ground(@location(0) out: vec2f, @location(1) darkness: vec2f) -> GroundFragment {
    let place = scene.ground.xyz + vec3f(out.x, 0.0, out.y) * scene.ground.w;
    return GroundFragment(scene.view_projection * vec4f(place, 1.0), out, darkness);
}

@fragment
fn fs_ground(in: GroundFragment) -> @location(0) vec4f {
    let fade = 1.0 - smoothstep(0.35, 1.0, length(in.out));
    let dark_stage = scene.tissue.w;
    let sky = mix(0.55, 0.75, dark_stage) * in.darkness.x;
    let key = mix(0.34, 0.5, dark_stage) * in.darkness.y;
    let shadow = fade * (1.0 - (1.0 - sky) * (1.0 - key));
    let pool = dark_stage * 0.10 * fade * fade * (1.0 - shadow);
    let noise = dither(in.clip.xy) * step(0.002, fade);
    return vec4f(vec3f(max(pool + noise * dark_stage, 0.0)), max(shadow + noise, 0.0));
}
