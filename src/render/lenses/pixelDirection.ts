import {
  abs,
  attribute,
  clamp,
  cos,
  Fn,
  float,
  floor,
  If,
  length,
  max,
  normalize,
  select,
  sin,
  vec2,
  vec3,
} from 'three/tsl';
import { CUBE_FACES } from '../../scene/view/lenses/cubeFaces.ts';
import type { Bool, Float, Vec2, Vec3 } from '../../shaders/types.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { frustumTangents } from '../gpu/fullScreenPass.ts';
import { LENS_NUMBERS, type LensUniforms } from './lensUniforms.ts';

/** Unit direction of this pixel in the observer's frame, on the world axes that the boost carries; that of a fisheye goes on beyond its circle. */
export function pixelDirection(uniforms: FrameUniforms): Vec3 {
  const place = attribute<'vec3'>('position', 'vec3').xy.add(uniforms.jitter).toVar();
  return uniforms.orientation.mul(cameraDirection(place, uniforms));
}

/** The same of a place of the picture, −1 … 1 to the right and up, on the camera's axes. */
export function cameraDirection(place: Vec2, uniforms: FrameUniforms): Vec3 {
  const { lens } = uniforms;
  return Fn(() => {
    const direction = vec3(frustumTangents(place, uniforms), -1).toVar();
    If(lens.kind.greaterThan(LENS_NUMBERS.perspective), () => {
      direction.assign(panoramicDirection(place, lens));
    });
    return normalize(direction);
  })();
}

/** Whether a picture shows something at a place. */
export function isInPicture(place: Vec2, { kind, scale }: LensUniforms): Bool {
  const [x, y] = [abs(place.x.mul(scale.x)), abs(place.y.mul(scale.y))];
  const reach = select(kind.equal(LENS_NUMBERS.fisheye), length(place.mul(scale)), max(x, y));
  return kind.equal(LENS_NUMBERS.perspective).or(reach.lessThanEqual(1));
}

/** 1 where the picture shows something, 0 beside the part that the lens fills. */
export const shownHere = ({ jitter, lens }: FrameUniforms): Float =>
  select(isInPicture(attribute<'vec3'>('position', 'vec3').xy.add(jitter), lens), float(1), 0);

/** `lensDirection` of scene/view/lenses/lenses.ts for the panoramic kinds; beside the part that they fill, formulas simply go on. */
export function panoramicDirection(place: Vec2, { kind, scale, aperture, elevation, grid }: LensUniforms): Vec3 {
  const filled = place.mul(scale).toVar();
  const direction = equirectangularDirection(filled).toVar();
  If(kind.equal(LENS_NUMBERS.fisheye), () => {
    direction.assign(fisheyeDirection(filled, aperture, elevation));
  })
    .ElseIf(kind.equal(LENS_NUMBERS.cube), () => {
      direction.assign(cubeDirection(filled, grid));
    })
    .ElseIf(kind.equal(LENS_NUMBERS.stereo), () => {
      const down = select(filled.y.lessThan(0), float(1), -1);
      direction.assign(equirectangularDirection(vec2(filled.x, filled.y.mul(2).add(down))));
    });
  return direction;
}

/** `equirectangularModel.directionAt` */
function equirectangularDirection(place: Vec2): Vec3 {
  const longitude = place.x.mul(Math.PI);
  const latitude = place.y.mul(Math.PI / 2);
  const level = cos(latitude).toVar();
  return vec3(level.mul(sin(longitude)), sin(latitude), level.mul(cos(longitude)).negate());
}

/** `fisheyeModel.directionAt`; the circle's radius is 1. */
function fisheyeDirection(place: Vec2, aperture: Float, elevation: Float): Vec3 {
  const r = length(place).toVar();
  const theta = r.mul(aperture).mul(0.5).toVar();
  const spread = select(r.greaterThan(0), sin(theta).div(max(r, 1e-12)), aperture.mul(0.5)).toVar();
  const back = cos(theta).negate().toVar();
  const up = spread.mul(place.y).toVar();
  const [sine, cosine] = [sin(elevation).toVar(), cos(elevation).toVar()];
  return vec3(spread.mul(place.x), cosine.mul(up).sub(sine.mul(back)), sine.mul(up).add(cosine.mul(back)));
}

/** `cubeModel.directionAt`, not of unit length. `grid`: columns and rows of faces. */
function cubeDirection(place: Vec2, grid: Vec2): Vec3 {
  const across = vec2(place.x.add(1), place.y.oneMinus()).mul(0.5).mul(grid).toVar();
  const cell = clamp(floor(across), vec2(0), grid.sub(1)).toVar();
  const on = across.sub(cell).mul(2).sub(1).toVar();
  const face = cell.y.mul(grid.x).add(cell.x).toVar();
  const directionOn = (k: number): Vec3 => {
    const { forward, right, up } = CUBE_FACES[k];
    return vec3(...forward)
      .add(vec3(...right).mul(on.x))
      .sub(vec3(...up).mul(on.y));
  };
  return CUBE_FACES.slice(1).reduce(
    (before: Vec3, _, k) => select(face.greaterThan(k + 0.5), directionOn(k + 1), before),
    directionOn(0),
  );
}
