import { clamp, cross, dot, float, If, length, max, min, normalize, reflect, select, sqrt } from 'three/tsl';
import type { Float, Vec3 } from '../shaders/types.ts';
import type { AreaTexels } from './areaLights.ts';
import { type Look, mirroredLight } from './brdf.ts';
import { faceOutline, type Outline, outlineIrradiance, tubeOutline } from './outline.ts';
import { beamed, type Gathering, IRRADIANCE, RADIANCE } from './radiance.ts';
import { AT_REST, passageBetween, type Rest } from './restFrame.ts';
import { shaped } from './shaping.ts';
import type { Uniforms } from './uniforms.ts';

/** A surface that a lamp shines on, and where it is: `dx` observer → surface [m], world. */
export interface Receiver {
  readonly look: Look;
  readonly dx: Vec3;
  readonly rest: Rest;
  readonly uniforms: Uniforms;
}

/**
 * What a surface reflects of a lamp with a size, unhidden. The matt part is exact in the rest frame but for the Doppler factor, which is that of
 * the lamp's middle. The glossy part has all light come from the point of the lamp that is nearest to the mirrored ray, on a surface that is rougher by
 * the lamp's size. Source: Karis 2013, "Real shading in Unreal Engine 4", SIGGRAPH course notes, "Area lights".
 */
export function areaLight({ look, dx, rest, uniforms }: Receiver, lamp: AreaTexels, eye: Gathering): void {
  const { N, V } = look;
  const centre = lamp.place.sub(dx).toVar();
  const toCentre = normalize(centre).toVar();
  const front = normalize(cross(lamp.Y, lamp.X)).toVar();
  const lit = lamp.kind === 'cylinder' ? dot(centre, centre).greaterThan(0) : dot(centre, front).lessThan(0);
  If(lit, () => {
    const share = shaped({ ...lamp, front }, toCentre.negate());
    const matt = outlineIrradiance(inRest(outlineOf(lamp, centre), rest), N);
    const ray = rest.out(normalize(reflect(V.negate(), N))).toVar();
    const toward = rest.into(normalize(nearestTo(ray, lamp, centre, front))).toVar();
    const facing = facingFactor(lamp, centre, toCentre, front).toVar();
    // A mirror shows the lamp's own radiance: so the widening across times that along is Ω/4π.
    const widening = sqrt(facing.div(4 * Math.PI)).toVar();
    const stretch = sqrt(slenderness(lamp, toCentre)).toVar();
    const glossy = mirroredLight(look, toward, widening.div(stretch), widening.mul(stretch)).mul(facing);
    const passage = passageBetween(toCentre, rest, AT_REST);
    // The outline is that of the rest frame; the facing factor the world's, which D² belongs to.
    const ofFacing = passage.D ? glossy.mul(beamed(passage.D, IRRADIANCE - RADIANCE, uniforms)) : glossy;
    const ofOutline = look.diffuse.mul(matt.div(Math.PI));
    eye.send(lamp.color, ofOutline.add(ofFacing).mul(share), passage, RADIANCE);
  });
}

const outlineOf = ({ kind, X, Y, radius }: AreaTexels, centre: Vec3): Outline =>
  kind === 'cylinder' ? tubeOutline(centre, X, radius) : faceOutline(kind, centre, X, Y);

const inRest = ({ count, corner }: Outline, rest: Rest): Outline => ({
  count,
  corner: (k) => rest.into(normalize(corner(k))),
});

/** Length over breadth, as it is seen. */
function slenderness({ kind, X, Y, radius }: AreaTexels, toCentre: Vec3): Float {
  if (kind === 'disk') return float(1);
  if (kind === 'rect') return length(X).div(length(Y));
  const along = dot(toCentre, normalize(X));
  return length(X)
    .div(radius)
    .mul(sqrt(max(along.mul(along).oneMinus(), 1e-6)));
}

/** Irradiance of a surface that faces it, over its radiance: as of a disk with its area that is seen from its axis, πA/(A + πd²). */
function facingFactor({ kind, X, Y, radius }: AreaTexels, centre: Vec3, toCentre: Vec3, front: Vec3): Float {
  const along = dot(toCentre, normalize(X));
  const shown = {
    rect: () => length(X).mul(length(Y)).mul(4).mul(dot(toCentre, front).negate()),
    disk: () => radius.mul(radius).mul(Math.PI).mul(dot(toCentre, front).negate()),
    cylinder: () =>
      length(X)
        .mul(radius)
        .mul(4)
        .mul(sqrt(max(along.mul(along).oneMinus(), 0))),
  }
    [kind]()
    .toVar();
  return shown.mul(Math.PI).div(shown.add(dot(centre, centre).mul(Math.PI)).max(1e-12));
}

/** The point of the lamp that is nearest to a unit ray, relative to the ray's beginning. */
function nearestTo(ray: Vec3, lamp: AreaTexels, centre: Vec3, front: Vec3): Vec3 {
  return lamp.kind === 'cylinder' ? nearestOfTube(ray, lamp, centre) : nearestOfFace(ray, lamp, centre, front);
}

function nearestOfFace(ray: Vec3, { kind, X, Y }: AreaTexels, centre: Vec3, front: Vec3): Vec3 {
  const [depth, slope] = [dot(centre, front).toVar(), dot(ray, front).toVar()];
  // A ray that does not come to the face's plane is followed as far as its middle.
  const reach = select(slope.lessThan(-1e-4), min(depth.div(slope.min(-1e-4)), 1e6), length(centre));
  const off = ray.mul(reach).sub(centre).toVar();
  const x = dot(off, X).div(dot(X, X)).toVar();
  const y = dot(off, Y).div(dot(Y, Y)).toVar();
  if (kind === 'rect') return centre.add(X.mul(clamp(x, -1, 1))).add(Y.mul(clamp(y, -1, 1)));
  const inside = sqrt(x.mul(x).add(y.mul(y))).max(1);
  return centre.add(X.mul(x.div(inside))).add(Y.mul(y.div(inside)));
}

function nearestOfTube(ray: Vec3, { X, radius }: AreaTexels, centre: Vec3): Vec3 {
  const slope = dot(ray, X).toVar();
  const spread = dot(X, X).sub(slope.mul(slope)).max(1e-9);
  const s = clamp(slope.mul(dot(ray, centre)).sub(dot(centre, X)).div(spread), -1, 1);
  const axis = centre.add(X.mul(s)).toVar();
  const off = ray.mul(dot(ray, axis).max(0)).sub(axis).toVar();
  return axis.add(off.mul(min(radius.div(length(off).max(1e-9)), 1)));
}
