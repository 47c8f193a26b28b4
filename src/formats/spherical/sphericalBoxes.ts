import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type { SphericalCrop, SphericalPicture, StereoLayout } from '../../scene/view/sphericalPicture.ts';
import { joinedBytes } from '../files/joinedBytes.ts';
import { contentsAt, mp4Box, readMp4Boxes } from './mp4Boxes.ts';
import { areaProperties, cropOfValues, MADE_BY, stereoOf, unknownProjection, unknownStereo } from './panorama.ts';
import { checkedCrop, eyeSize, UNCROPPED, unlessWhole } from './sphericalPicture.ts';
import { xmlValues } from './xmlValues.ts';

/** Of `st3d`, by their number. */
const STEREO_MODES: readonly StereoLayout[] = ['none', 'top-bottom', 'left-right'];
/** Parts of a projection are 0.32 fixed-point numbers. */
const UNIT = 2 ** 32;
const V1_UUID = Uint8Array.of(
  ...[0xff, 0xcc, 0x82, 0x63, 0xf8, 0x55, 0x4a, 0x93, 0x88, 0x14, 0x58, 0x7a, 0x02, 0x52, 0x1f, 0xdd],
);

const u32 = (...values: readonly number[]): Uint8Array => {
  const bytes = new Uint8Array(4 * values.length);
  const view = new DataView(bytes.buffer);
  for (const [i, value] of values.entries()) view.setUint32(4 * i, value);
  return bytes;
};

/** Version 0, no flags. */
const VERSION = u32(0);
const utf8 = (text: string): Uint8Array => new TextEncoder().encode(text);

/**
 * The boxes `st3d`, for stereo, and `sv3d` of a visual sample entry. Source: Google, Spherical Video V2 RFC
 * (https://github.com/google/spatial-media/blob/master/docs/spherical-video-v2-rfc.md).
 */
export function sphericalV2(picture: SphericalPicture): Uint8Array {
  const header = mp4Box('svhd', VERSION, utf8(`${MADE_BY}\0`));
  const pose = mp4Box('prhd', VERSION, u32(0, 0, 0));
  const stereo = mp4Box('st3d', VERSION, Uint8Array.of(STEREO_MODES.indexOf(picture.stereo)));
  return joinedBytes([
    ...(picture.stereo === 'none' ? [] : [stereo]),
    mp4Box('sv3d', header, mp4Box('proj', pose, projectionBox(picture))),
  ]);
}

function projectionBox(picture: SphericalPicture): Uint8Array {
  if (picture.projection === 'cubemap') return mp4Box('cbmp', VERSION, u32(0, 0));
  const { top, bottom, left, right } = checkedCrop(picture.crop ?? UNCROPPED);
  return mp4Box('equi', VERSION, u32(...[top, bottom, left, right].map((part) => Math.round(part * UNIT))));
}

/** What the boxes of a visual sample entry say; undefined where they do not tell a projection. `place` is for messages. */
export function sphericalOfV2(boxes: Uint8Array, place: string): SphericalPicture | undefined {
  const [projection] = contentsAt(boxes, ['sv3d', 'proj'], place);
  if (!projection) return undefined;
  const [layout] = contentsAt(boxes, ['st3d'], place);
  const stereo = layout ? stereoOfNumber(fields(layout, 1, `${place}/st3d`).getUint8(0)) : 'none';
  const at = `${place}/sv3d/proj`;
  const data = readMp4Boxes(projection, at).boxes.find(({ type }) => type !== 'prhd');
  if (data?.type === 'equi') {
    const crop = cropOfBounds(fields(data.content, 16, `${at}/equi`));
    return { projection: 'equirectangular', stereo, ...(crop && { crop }) };
  }
  if (data?.type !== 'cbmp') throw unknownProjection(data?.type ?? at);
  const faces = fields(data.content, 8, `${at}/cbmp`);
  if (faces.getUint32(0) !== 0 || faces.getUint32(4) !== 0)
    throw new MessageError(
      msg`a cube map of layout ${faces.getUint32(0)} with ${faces.getUint32(4)} pixels of padding is not read; layout 0 without is`,
    );
  return { projection: 'cubemap', stereo };
}

function stereoOfNumber(mode: number): StereoLayout {
  if (mode >= STEREO_MODES.length) throw unknownStereo(mode);
  return STEREO_MODES[mode];
}

/** What follows version and flags. */
function fields(content: Uint8Array, size: number, place: string): DataView {
  if (content.length < VERSION.length + size)
    throw new MessageError(msg`${place} has ${content.length} bytes, less than ${VERSION.length + size}`);
  return new DataView(content.buffer, content.byteOffset + VERSION.length, size);
}

function cropOfBounds(bounds: DataView): SphericalCrop | undefined {
  const [top, bottom, left, right] = [0, 4, 8, 12].map((at) => bounds.getUint32(at) / UNIT);
  return unlessWhole(checkedCrop({ left, right, top, bottom }));
}

/**
 * The box `uuid` of a video track with RDF/XML, of equirectangular pictures only. Source: Google, Spherical Video RFC
 * (https://github.com/google/spatial-media/blob/master/docs/spherical-video-rfc.md); `size` is that of the frames.
 */
export function sphericalV1(picture: SphericalPicture, size: PictureSize): Uint8Array | undefined {
  if (picture.projection !== 'equirectangular') return undefined;
  const { stereo, crop } = picture;
  const properties = {
    'GSpherical:Spherical': 'true',
    'GSpherical:Stitched': 'true',
    'GSpherical:StitchingSoftware': MADE_BY,
    'GSpherical:ProjectionType': 'equirectangular',
    'GSpherical:StereoMode': stereo === 'none' ? 'mono' : stereo,
    ...(crop && areaProperties('GSpherical', crop, eyeSize(size, stereo))),
  };
  const elements = Object.entries(properties).map(([name, value]) => `<${name}>${value}</${name}>`);
  const namespaces =
    'xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" xmlns:GSpherical="http://ns.google.com/videos/1.0/spherical/"';
  const xml = `<?xml version="1.0"?><rdf:SphericalVideo ${namespaces}>${elements.join('')}</rdf:SphericalVideo>`;
  return mp4Box('uuid', V1_UUID, utf8(xml));
}

/** Whether the content of a `uuid` box is that of Spherical Video V1. */
export const isSphericalV1 = (content: Uint8Array): boolean => V1_UUID.every((byte, i) => content[i] === byte);

/** What the content of a V1 box says; undefined where it says that the film is not spherical. */
export function sphericalOfV1(content: Uint8Array): SphericalPicture | undefined {
  const values = xmlValues(content.subarray(V1_UUID.length));
  if (!/^(true|1)$/i.test(values.get('GSpherical:Spherical') ?? '')) return undefined;
  const projection = values.get('GSpherical:ProjectionType') ?? '';
  if (projection !== 'equirectangular') throw unknownProjection(projection);
  const crop = cropOfValues('GSpherical', values);
  return { projection, stereo: stereoOf(values.get('GSpherical:StereoMode')), ...(crop && { crop }) };
}
