//! Textures that hold records of four words for shaders to load.

use super::DrawError;

/// Records in a row: the widest texture that WebGL2 promises. The shaders know it too.
const ROW: u32 = 2048;

/// Four words.
pub const RECORD_BYTES: usize = 16;

/// A texture of 16-byte records that grows when it must and is reused when it can.
pub struct DataTexture {
    texture: wgpu::Texture,
    pub view: wgpu::TextureView,
}

impl DataTexture {
    /// An empty texture of one row; its records are zero.
    pub fn new(device: &wgpu::Device) -> DataTexture {
        DataTexture::with_rows(device, 1)
    }

    /// Writes records from the first texel on. Returns whether the texture had to be made anew, so
    /// that bind groups with it are stale. Errors if the records need more rows than a texture of
    /// the device has.
    pub fn write(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        records: &[u8],
    ) -> Result<bool, DrawError> {
        debug_assert!(records.len().is_multiple_of(RECORD_BYTES));
        let count = (records.len() / RECORD_BYTES) as u32;
        let rows = count.div_ceil(ROW);
        let most = device.limits().max_texture_dimension_2d;
        if rows > most {
            return Err(DrawError::TooLarge { rows, most });
        }
        let grown = rows > self.texture.height();
        if grown {
            *self = DataTexture::with_rows(device, rows.next_power_of_two().min(most));
        }
        let full_rows = count / ROW;
        let (full, rest) = records.split_at((full_rows * ROW) as usize * RECORD_BYTES);
        self.write_rows(queue, 0, ROW, full_rows, full);
        self.write_rows(queue, full_rows, count % ROW, 1, rest);
        Ok(grown)
    }

    fn with_rows(device: &wgpu::Device, rows: u32) -> DataTexture {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: ROW, height: rows, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Uint,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&Default::default());
        DataTexture { texture, view }
    }

    fn write_rows(&self, queue: &wgpu::Queue, y: u32, width: u32, height: u32, bytes: &[u8]) {
        if bytes.is_empty() {
            return;
        }
        let mut target = self.texture.as_image_copy();
        target.origin.y = y;
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(width * RECORD_BYTES as u32),
            rows_per_image: None,
        };
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        queue.write_texture(target, bytes, layout, size);
    }
}

impl Drop for DataTexture {
    fn drop(&mut self) {
        self.texture.destroy();
    }
}
