import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import type { PictureSize } from '../../scene/view/pictureSize.ts';
import type {
  EquirectangularPicture,
  SphericalCrop,
  SphericalPicture,
  StereoLayout,
} from '../../scene/view/sphericalPicture.ts';
import { cropOfArea, croppedArea, eyeSize } from './sphericalPicture.ts';
import { xmlValues } from './xmlValues.ts';

/** The program that made the picture, as files name it. */
export const MADE_BY = 'Slowlight';

type PanoramaValues = ReadonlyMap<string, string>;
type PanoramaProperties = Readonly<Record<string, string | number>>;

/**
 * An XMP packet (ISO 16684-1) with Google's panorama properties (https://developers.google.com/streetview/spherical-metadata).
 * These cannot tell stereo, and describe one eye's view, as those of films do: the layout is the property of films,
 * GSpherical:StereoMode, as viewers of pictures have none of their own.
 */
export function panoramaXmp(picture: SphericalPicture, size: PictureSize): string {
  const properties = Object.entries(panoramaProperties(picture, size));
  return `<?xpacket begin="\uFEFF" id="W5M0MpCehiHzreSzNTczkc9d"?>
<x:xmpmeta xmlns:x="adobe:ns:meta/">
  <rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">
    <rdf:Description rdf:about=""
      xmlns:GPano="http://ns.google.com/photos/1.0/panorama/"
      xmlns:GSpherical="http://ns.google.com/videos/1.0/spherical/"
${properties.map(([name, value]) => `      ${name}="${value}"`).join('\n')}/>
  </rdf:RDF>
</x:xmpmeta>
<?xpacket end="r"?>`;
}

function panoramaProperties(picture: SphericalPicture, size: PictureSize): PanoramaProperties {
  const eye = eyeSize(size, picture.stereo);
  return {
    'GPano:ProjectionType': picture.projection,
    'GPano:UsePanoramaViewer': 'True',
    'GPano:StitchingSoftware': MADE_BY,
    ...(picture.projection === 'equirectangular' && {
      ...areaProperties('GPano', picture.crop, eye),
      ...headingProperty(picture),
    }),
    ...(picture.stereo !== 'none' && { 'GSpherical:StereoMode': picture.stereo }),
  };
}

function headingProperty({ heading }: EquirectangularPicture): PanoramaProperties {
  if (heading === undefined) return {};
  const degrees = (((heading * 180) / Math.PI) % 360) + 360;
  if (!Number.isFinite(degrees)) throw new MessageError(msg`${heading} is no heading`);
  return { 'GPano:PoseHeadingDegrees': Number((degrees % 360).toFixed(6)) % 360 };
}

/** The crop of an eye's view, with the prefix of pictures or of films. */
export function areaProperties(prefix: string, crop: SphericalCrop | undefined, eye: PictureSize): PanoramaProperties {
  const { full, area, left, top } = croppedArea(crop, eye);
  return {
    [`${prefix}:CroppedAreaImageWidthPixels`]: area.width,
    [`${prefix}:CroppedAreaImageHeightPixels`]: area.height,
    [`${prefix}:FullPanoWidthPixels`]: full.width,
    [`${prefix}:FullPanoHeightPixels`]: full.height,
    [`${prefix}:CroppedAreaLeftPixels`]: left,
    [`${prefix}:CroppedAreaTopPixels`]: top,
  };
}

/** What an XMP packet says; undefined where it says nothing of a panorama, or asks to be shown flat. Throws for other projections than ours. */
export function panoramaOfXmp(packet: Uint8Array): SphericalPicture | undefined {
  const values = xmlValues(packet);
  const projection = values.get('GPano:ProjectionType');
  if (projection === undefined || /^false$/i.test(values.get('GPano:UsePanoramaViewer') ?? '')) return undefined;
  const stereo = stereoOf(values.get('GSpherical:StereoMode'));
  if (projection === 'cubemap') return { projection, stereo };
  if (projection !== 'equirectangular') throw unknownProjection(projection);
  const crop = cropOfValues('GPano', values);
  const degrees = numberOf('GPano:PoseHeadingDegrees', values);
  return {
    projection,
    stereo,
    ...(crop && { crop }),
    ...(degrees !== undefined && { heading: (degrees * Math.PI) / 180 }),
  };
}

/** A projection that is not read. */
export const unknownProjection = (projection: string): MessageError =>
  new MessageError(msg`the projection ${projection} is not read; equirectangular and cubemap are`);

const STEREO_MODES: Readonly<Record<string, StereoLayout>> = {
  mono: 'none',
  'top-bottom': 'top-bottom',
  'left-right': 'left-right',
};

/** The layout that GSpherical:StereoMode names. */
export function stereoOf(mode = 'mono'): StereoLayout {
  if (!Object.hasOwn(STEREO_MODES, mode)) throw unknownStereo(mode);
  return STEREO_MODES[mode];
}

/** A layout of two eyes' views that is not read. */
export const unknownStereo = (mode: string | number): MessageError =>
  new MessageError(msg`the stereo layout ${mode} is not read; mono, top-bottom and left-right are`);

/** The crop where it is told whole. */
export function cropOfValues(prefix: string, values: PanoramaValues): SphericalCrop | undefined {
  const [width, height, fullWidth, fullHeight, left, top] = [
    'CroppedAreaImageWidthPixels',
    'CroppedAreaImageHeightPixels',
    'FullPanoWidthPixels',
    'FullPanoHeightPixels',
    'CroppedAreaLeftPixels',
    'CroppedAreaTopPixels',
  ].map((name) => numberOf(`${prefix}:${name}`, values));
  if (width === undefined || height === undefined || fullWidth === undefined || fullHeight === undefined)
    return undefined;
  return cropOfArea({
    full: { width: fullWidth, height: fullHeight },
    area: { width, height },
    left: left ?? 0,
    top: top ?? 0,
  });
}

function numberOf(name: string, values: PanoramaValues): number | undefined {
  const text = values.get(name);
  if (text === undefined) return undefined;
  const value = Number(text);
  if (text === '' || !Number.isFinite(value)) throw new MessageError(msg`${name} is “${text}”, which is no number`);
  return value;
}
