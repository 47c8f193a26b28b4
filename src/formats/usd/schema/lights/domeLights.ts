import { toHalf } from '../../../../math/half.ts';
import * as mat3 from '../../../../math/mat3.ts';
import * as mat4 from '../../../../math/mat4.ts';
import { fromAxisAngle, IDENTITY, multiply, type Quat } from '../../../../math/quat.ts';
import type { Vec3 } from '../../../../math/vec3.ts';
import { msg } from '../../../../messages/message.ts';
import { directionFromLatLong, latLongFromDirection } from '../../../../scene/lights/latLong.ts';
import { sampleTexture } from '../../../../scene/materials/sampleTexture.ts';
import type { DomeLight, RadianceTexture } from '../../../../scene/types.ts';
import { SKY_ATTRIBUTES } from '../../../attributes/hints.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, textAt, textOf, valueAt, vec3At } from '../../layer/attributes.ts';
import type { PrimSpec } from '../../layer/layer.ts';
import { type StageContext, upAxisOf } from '../context.ts';
import type { TextureLoader } from '../materials/textureLoader.ts';
import type { StageTransform } from '../transforms/stageTransform.ts';
import { emissionOfColor } from './lightInputs.ts';

type DomeImage = NonNullable<DomeLight['texture']>;

/** A dome's environment map in latitude–longitude form, with its orientation in the world. */
export async function domeTexture(
  context: StageContext,
  textures: TextureLoader,
  prim: PrimSpec,
  frame: StageTransform,
): Promise<Pick<DomeLight, 'texture' | 'orientation'>> {
  const file = valueAt(attributeOf(prim, 'inputs:texture:file'), context.startCode);
  if (!textOf(file)) return {};
  const place = MAPPINGS.get(formatOf(context, prim));
  if (!place) return {};
  const picture = await textures.domeTexture(file, prim);
  if (!picture) return {};
  const toWorld = mat4.linearPart(frame.matrixAt(context.startCode));
  const isMirror = mat3.determinant(toWorld) < 0;
  const turn = mat4.decomposeRigid(mat4.fromParts(isMirror ? mat3.multiply(toWorld, MIRROR_X) : toWorld, [0, 0, 0]));
  reportFormatGuess(context, prim, picture);
  return {
    texture: place === latLongFromDirection && !isMirror ? picture : resampledPanorama(picture, place, isMirror),
    orientation: multiply(turn.pose.orientation, poleOf(context, prim)),
  };
}

/** The attributes `slowlight:sky:horizon` and `:ground`, relative to the light's brightness; the horizon defaults to the zenith's colour, the ground to the horizon's. */
export function skyGradient(context: StageContext, prim: PrimSpec, zenith: Vec3): Pick<DomeLight, 'gradient'> {
  const [horizon, ground] = SKY_ATTRIBUTES.map((name) => {
    const color = vec3At(prim, name, context.startCode);
    return color && emissionOfColor(context, prim, color);
  });
  if (!horizon && !ground) return {};
  return { gradient: { horizon: horizon ?? zenith, ground: ground ?? horizon ?? zenith } };
}

/** x → −x */
const MIRROR_X: mat3.Mat3 = [-1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Maps a direction in the dome's axes to the map, u to the right and v up. */
type TextureMapping = (direction: Vec3) => readonly [u: number, v: number];

/** A ball-shaped map with +Z at its centre; `radius` (0 … 1) of the angle π · `turn` from +Z. */
const ballMapping =
  (radius: (turn: number) => number): TextureMapping =>
  ([x, y, z]) => {
    const sine = Math.hypot(x, y);
    if (sine === 0) return [z < 0 ? 1 : 0.5, 0.5];
    const r = radius(Math.atan2(sine, z) / Math.PI) / sine;
    return [(1 + r * x) / 2, (1 + r * y) / 2];
  };

/**
 * `mirroredBall`: a mirror ball photographed from infinity along −Z: at a distance of r radii from its centre the normal is at the angle sin⁻¹ r
 * from +Z, and the reflected direction at twice that. `angular`: r is proportional to the angle, as in Debevec's light probes
 * (https://www.pauldebevec.com/Probes, (u, v) = (x, y) cos⁻¹(z)/(π √(x² + y²))).
 */
const MAPPINGS: ReadonlyMap<string, TextureMapping> = new Map([
  ['latlong', latLongFromDirection],
  ['mirroredBall', ballMapping((turn) => Math.sin((Math.PI * turn) / 2))],
  ['angular', ballMapping((turn) => turn)],
]);

/** `automatic` is `latlong`: no supported file type specifies another layout. */
function formatOf(context: StageContext, prim: PrimSpec): string {
  const written = textAt(prim, 'inputs:texture:format', context.startCode) ?? 'automatic';
  const format = written === 'automatic' ? 'latlong' : written;
  if (!MAPPINGS.has(format)) {
    const message = msg`the format ${written.slice(0, 40)} of its picture is not read, so it shines in its colour alone; convert the picture to latlong`;
    report(context, 'warning', 'usd.light-input', prim.path, message);
  }
  return format;
}

function reportFormatGuess(context: StageContext, prim: PrimSpec, { width, height }: DomeImage): void {
  const written = textAt(prim, 'inputs:texture:format', context.startCode) ?? 'automatic';
  if (written !== 'automatic' || width !== height || width === 1) return;
  const message = msg`its picture of ${width} × ${height} pixels is taken for one by latitude and longitude; of a mirror ball inputs:texture:format should say "mirroredBall" or "angular"`;
  report(context, 'info', 'usd.light-input', prim.path, message);
}

/** The pole of a DomeLight is its +Y axis; of a DomeLight_1 its poleAxis, by default the stage's up axis. */
function poleOf(context: StageContext, prim: PrimSpec): Quat {
  if (prim.typeName === 'DomeLight') return IDENTITY;
  const written = textAt(prim, 'poleAxis', undefined) ?? 'scene';
  const axis = written === 'scene' ? upAxisOf(context) : written;
  return axis === 'Z' ? fromAxisAngle([1, 0, 0], Math.PI / 2) : IDENTITY;
}

const MAX_PANORAMA_ROWS = 4096;

/** Resamples a map to latitude–longitude form; ball-shaped ones at the resolution of their centre, where they are finest. */
function resampledPanorama(picture: DomeImage, place: TextureMapping, isMirror: boolean): RadianceTexture {
  const isBall = place !== latLongFromDirection;
  const height = isBall ? Math.min(Math.max(picture.width, picture.height), MAX_PANORAMA_ROWS) : picture.height;
  const width = isBall ? 2 * height : picture.width;
  const source = isBall ? ({ ...picture, wrapS: 'clamp' } as DomeImage) : picture;
  const data = new Uint16Array(4 * width * height);
  for (let row = 0, i = 0; row < height; row++)
    for (let column = 0; column < width; column++, i += 4) {
      const [x, y, z] = directionFromLatLong((column + 0.5) / width, 1 - (row + 0.5) / height);
      const [u, v] = place([isMirror ? -x : x, y, z]);
      const [r, g, b] = sampleTexture(source, u, v);
      data.set([r, g, b, 1].map(toHalf), i);
    }
  return { ...picture, width, height, data, colorSpace: 'linear' };
}
