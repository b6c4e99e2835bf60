//! Diagrams in the bytes that the shaders read: `diagram.wgsl`.

use super::data_texture::RECORD_BYTES;
use crate::plants::{Diagram, Layer};
use crate::surface::{Cylinder, Wrap};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// How the image of a layer lies on the surface.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct Head {
    base: Vec3,
    /// 0 for an image that lies by leaf coordinates.
    height_cm: f32,
    axis: Vec3,
    from: f32,
    zero: Vec3,
    black: f32,
    /// Of the image's pixels.
    first_record: u32,
    width: u32,
    rows: u32,
    white: f32,
}

/// What covers the surface, in whole records: the colours of the triangles, or the heads of the
/// layers and then their pixels.
pub fn pack(diagram: &Diagram) -> Vec<u8> {
    let mut bytes = diagram.colours.as_flattened().to_vec();
    let mut first_record = diagram.layers.len() * size_of::<Head>() / RECORD_BYTES;
    for layer in &diagram.layers {
        bytes.extend_from_slice(bytemuck::bytes_of(&Head::new(layer, first_record as u32)));
        first_record += layer.image.grey.len().div_ceil(RECORD_BYTES);
    }
    fill_record(&mut bytes);
    for layer in &diagram.layers {
        bytes.extend_from_slice(&layer.image.grey);
        fill_record(&mut bytes);
    }
    bytes
}

impl Head {
    fn new(layer: &Layer, first_record: u32) -> Head {
        let mut head = Head {
            from: layer.from,
            black: layer.black,
            white: layer.white,
            first_record,
            width: layer.image.width,
            rows: layer.image.height,
            ..Head::zeroed()
        };
        if let Wrap::Cylinder(Cylinder { base, axis, zero, height }) = layer.wrap {
            (head.base, head.axis, head.zero, head.height_cm) = (base, axis, zero, height);
        }
        head
    }
}

fn fill_record(bytes: &mut Vec<u8>) {
    bytes.resize(bytes.len().next_multiple_of(RECORD_BYTES), 0);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::ControlImage;

    #[test]
    fn pixels_stand_where_the_heads_say() {
        let image = |width, height, grey| ControlImage { width, height, grey: vec![grey; 20] };
        let layer = |image| Layer { wrap: Wrap::Leaf, image, from: 1.0, black: 0.5, white: 1.0 };
        let layers = vec![layer(image(5, 4, 7)), layer(image(10, 2, 9))];
        let bytes = pack(&Diagram { layers, ..Diagram::default() });
        assert_eq!(bytes.len(), (4 + 4 + 2 + 2) * RECORD_BYTES);
        let words = |record: usize| [0, 4, 8].map(|k| bytes[record * RECORD_BYTES + k]);
        assert_eq!((words(3), words(7)), ([8, 5, 4], [10, 10, 2]));
        assert_eq!(bytes[8 * RECORD_BYTES..][..20], [7; 20]);
        assert_eq!(bytes[10 * RECORD_BYTES..][..20], [9; 20]);
    }

    #[test]
    fn cells_have_nothing_to_pack() {
        assert!(pack(&Diagram::default()).is_empty());
    }
}
