import { radians } from '../../math/angle.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat } from '../../math/quat.ts';
import { scale } from '../../math/vec3.ts';
import { msg } from '../../messages/message.ts';
import { isDomeLight } from '../../scene/lights/lightKinds.ts';
import { fisheyeLens, LENS_CHOICES } from '../../scene/view/lenses/lensChoice.ts';
import { DAYLIGHT } from '../../spectrum/sources/lightSpectrum.ts';
import { fisheyeParams } from '../common/fisheyeParams.ts';
import { nodeRefusal, readOrRefuse } from '../common/params.ts';
import { defineNode } from '../defineNode.ts';
import { emissionParam, lightBase, nameParam } from './lightParams.ts';

/** Turns the zenith of a panorama, +Y, to +Z, and what is ahead of it from −Z to +Y. */
const Z_UP = fromAxisAngle([1, 0, 0], Math.PI / 2);

/** A picture or a film of all directions as surroundings at infinity. */
export const panoramaNode = defineNode({
  id: 'panorama',
  title: msg`Panorama`,
  help: msg`A picture or a film of all directions as surroundings at infinity, which also shine on things: by latitude and longitude, or six faces of a cube. It replaces the sky of the files in Scene.`,
  category: 'composition',
  params: {
    name: nameParam('Panorama'),
    source: {
      kind: 'text',
      title: msg`File`,
      help: msg`A picture twice as wide as high, or of six square faces: PNG, JPEG, WebP, AVIF, Radiance (.hdr) or OpenEXR, or such a film: MP4, QuickTime, WebM or Matroska. Of a scene its dome is taken.`,
      default: '',
      file: true,
    },
    lens: {
      kind: 'choice',
      title: msg`Lens`,
      help: msg`Of the picture. As the file says, or by its shape: latitude and longitude, or faces of a cube. A fisheye and a dome master are circles in the middle of a picture.`,
      default: 'file',
      options: [
        { value: 'file', title: msg`As the file says` },
        { value: 'fisheye', title: LENS_CHOICES.fisheye },
        { value: 'dome', title: LENS_CHOICES.dome },
      ],
    },
    ...fisheyeParams,
    rotation: {
      kind: 'number',
      title: msg`Rotation`,
      help: msg`Turns the surroundings to the left, about the zenith.`,
      unit: '°',
      default: 0,
      min: -360,
      max: 360,
      step: 1,
    },
    tilt: {
      kind: 'number',
      title: msg`Tilt`,
      help: msg`Raises what is in the middle of the picture, before it is turned.`,
      unit: '°',
      default: 0,
      min: -180,
      max: 180,
      step: 1,
    },
    up: {
      kind: 'choice',
      title: msg`Zenith`,
      help: msg`The axis of the scene that points to the upper edge of the picture.`,
      default: 'Y',
      options: [
        { value: 'Y', title: 'Y' },
        { value: 'Z', title: 'Z' },
      ],
    },
    brightness: {
      kind: 'number',
      title: msg`Brightness`,
      help: msg`A factor of the picture’s light.`,
      default: 1,
      min: 0,
      max: 1e9,
      step: 0.1,
      slider: false,
    },
    reading: {
      kind: 'choice',
      title: msg`Its colours are`,
      help: msg`Spectra of the picture’s colours, which determine them after a Doppler shift. A sky: white, blue scattered and red transmitted daylight, and a filter for the rest. A filter: of a light of the spectrum below, or of a connected one.`,
      default: 'sky',
      options: [
        { value: 'sky', title: msg`Those of a sky` },
        { value: 'filter', title: msg`A filter before a light` },
      ],
    },
    filmStart: {
      kind: 'number',
      title: msg`Film starts at`,
      help: msg`World time at which the first picture of a film is in the origin.`,
      unit: 's',
      default: 0,
      min: -1e6,
      max: 1e6,
      step: 0.1,
      slider: false,
    },
    filmEnd: {
      kind: 'choice',
      title: msg`Before and after it`,
      help: msg`What is seen of a film before it starts and after it ends.`,
      default: 'hold',
      options: [
        { value: 'hold', title: msg`Its first and last picture` },
        { value: 'repeat', title: msg`It repeats` },
      ],
    },
    madeOf: { ...emissionParam, onlyWhen: { param: 'reading', is: 'filter' } },
  },
  inputs: { spectrum: { type: 'spectrum', optional: true } },
  outputs: { lights: { type: 'lights' } },
  async evaluate(
    { spectrum },
    { name, source, lens, aperture, domeTilt, rotation, tilt, up, brightness, reading, filmStart, filmEnd, madeOf },
    { node, services, signal, progress },
  ) {
    if (source === '') throw nodeRefusal('panorama.none', node, msg`no picture is chosen; name one`);
    const fisheye = lens === 'file' ? undefined : fisheyeLens({ lens, aperture, domeTilt });
    const request = { variants: new Map<string, string>(), signal, progress, ...(fisheye && { fisheye }) };
    const { scene } = await readOrRefuse(() => services.readScene(source, request));
    const dome = scene.lights.find(isDomeLight);
    if (!dome) throw nodeRefusal('panorama.no-dome', node, msg`${source} has no surroundings; name a panorama`);
    const isFilter = reading === 'filter' || spectrum !== undefined;
    const { path, ...light } = lightBase(name, node, madeOf, spectrum);
    return {
      lights: [
        {
          ...dome,
          path,
          color: scale(dome.color, brightness),
          ...(dome.film && { film: { ...dome.film, start: filmStart, repeats: filmEnd === 'repeat' } }),
          orientation: multiply(turned(rotation, tilt, up), dome.orientation ?? IDENTITY),
          ...(isFilter && { spectrum: light.spectrum ?? DAYLIGHT }),
        },
      ],
    };
  },
});

/** Tilt [°] about +X, then rotation [°] about the zenith +Y, then the zenith to the scene's. */
function turned(rotation: number, tilt: number, up: 'Y' | 'Z'): Quat {
  const tilted = fromAxisAngle([1, 0, 0], radians(tilt));
  const upright = multiply(fromAxisAngle([0, 1, 0], radians(rotation)), tilted);
  return up === 'Z' ? multiply(Z_UP, upright) : upright;
}
