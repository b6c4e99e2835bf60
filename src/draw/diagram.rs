//! Diagrams in the records that the shaders read: `diagram.wgsl`.

use crate::plants::{Coat, Layer};
use crate::surface::Wrap;
use glam::{Vec3, Vec4};

/// What covers the surface, as records of four words.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Covering {
    /// 0: the mosaic; 1: a colour for each triangle; 2: layers of images.
    pub kind: u32,
    pub layers: u32,
    pub records: Vec<[u32; 4]>,
}

impl Covering {
    pub fn new(coat: &Coat) -> Covering {
        match coat {
            Coat::Triangles(colours) => {
                let word = |[r, g, b]: [u8; 3]| u32::from_le_bytes([r, g, b, 0]);
                let words: Vec<u32> = colours.iter().map(|&colour| word(colour)).collect();
                Covering { kind: 1, layers: 0, records: records(&words) }
            }
            Coat::Layers(layers) => Covering::of_layers(layers),
        }
    }

    /// First four records for each layer, then the pixels of all.
    fn of_layers(layers: &[Layer]) -> Covering {
        let mut heads = Vec::new();
        let mut pixels = Vec::new();
        for layer in layers {
            let (base, axis, zero, height) = match layer.wrap {
                Wrap::Cylinder(c) => (c.base, c.axis, c.zero, c.height),
                // Height 0: by leaf coordinates.
                Wrap::Leaf => (Vec3::ZERO, Vec3::ZERO, Vec3::ZERO, 0.0),
            };
            let floats = [base.extend(height), axis.extend(layer.from), zero.extend(layer.to)];
            heads.extend(floats.map(|v: Vec4| v.to_array().map(f32::to_bits)));
            let first = (4 * layers.len() + pixels.len()) as u32;
            heads.push([first, layer.image.width, layer.image.height, 0]);
            let bytes = layer.image.grey.chunks(4);
            let word = |four: &[u8]| (0..).zip(four).map(|(k, &b)| u32::from(b) << (8 * k)).sum();
            pixels.extend(records(&bytes.map(word).collect::<Vec<u32>>()));
        }
        Covering { kind: 2, layers: layers.len() as u32, records: [heads, pixels].concat() }
    }
}

/// Words four by four, filled up with zeros.
fn records(words: &[u32]) -> Vec<[u32; 4]> {
    let word = |four: &[u32], k: usize| four.get(k).copied().unwrap_or_default();
    words.chunks(4).map(|four| std::array::from_fn(|k| word(four, k))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::ControlImage;

    #[test]
    fn pixels_stand_where_the_heads_say() {
        let image = |width, height, grey| ControlImage { width, height, grey: vec![grey; 20] };
        let layer = |image| Layer { wrap: Wrap::Leaf, image, from: 1.0, to: 0.5 };
        let covering =
            Covering::new(&Coat::Layers(vec![layer(image(5, 4, 7)), layer(image(10, 2, 255))]));
        assert_eq!((covering.kind, covering.layers), (2, 2));
        assert_eq!((covering.records[3], covering.records[7]), ([8, 5, 4, 0], [10, 10, 2, 0]));
        assert_eq!(covering.records[8], [0x0707_0707; 4]);
        assert_eq!(covering.records[11], [u32::MAX, 0, 0, 0]);
        assert_eq!(covering.records.len(), 12);
    }

    #[test]
    fn four_triangles_share_a_record() {
        let covering = Covering::new(&Coat::Triangles(vec![[1, 2, 3]; 5]));
        assert_eq!(covering.records, [[0x0003_0201; 4], [0x0003_0201, 0, 0, 0]]);
    }
}
