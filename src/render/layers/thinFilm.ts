import { clamp, cos, dot, float, int, max, sqrt, uniformArray, vec3 } from 'three/tsl';
import { Vector4 } from 'three/webgpu';
import type { Float, Vec3, Vec4 } from '../../shaders/types.ts';
import { toLinearSrgb } from '../../spectrum/color/observerColor.ts';
import { colorMatching } from '../../spectrum/observer/standardObserver.ts';
import { basisAt } from '../../spectrum/reflectance/spectralFilter.ts';
import { DAYLIGHT, spectralRadiance } from '../../spectrum/sources/lightSpectrum.ts';
import { loopTimes } from '../shadows/atlas/atlasLookups.ts';

/** A film at a fragment; thickness in micrometres. */
export interface FilmNodes {
  readonly ior: Float;
  readonly thickness: Float;
}

/** What a film reflects: linear sRGB in daylight, and the mean over the invisible. */
export interface FilmReflectance {
  readonly rgb: Vec3;
  readonly invisible: Float;
}

/** Wavelengths at which a film's reflectance is summed, between these [nm]. */
const [SAMPLES, SHORTEST, LONGEST] = [32, 390, 710];

/** By wavelength: its weights in linear sRGB of daylight, which sum to 1, and itself [µm]; and the basis of filters there. */
function tables(): { readonly weights: Vector4[]; readonly basis: Vector4[] } {
  const wavelengths = Array.from(
    { length: SAMPLES },
    (_, k) => (SHORTEST + ((LONGEST - SHORTEST) * (k + 0.5)) / SAMPLES) * 1e-9,
  );
  const seen = wavelengths.map((l) => toLinearSrgb(colorMatching(l)).map((x) => x * spectralRadiance(DAYLIGHT, l)));
  const total = [0, 1, 2].map((j) => seen.reduce((sum, one) => sum + one[j], 0));
  return {
    weights: seen.map(([r, g, b], k) => new Vector4(r / total[0], g / total[1], b / total[2], wavelengths[k] * 1e6)),
    basis: wavelengths.map((l) => new Vector4(...basisAt(l), 0)),
  };
}

/** The twin of `thinFilmReflectance` (src/physics/optics/thinFilm.ts), summed over daylight, for light from the cosine `c` on a surface of F₀ below. */
export function filmReflectance(c: Float, { ior: n, thickness }: FilmNodes, F0: Vec4): FilmReflectance {
  const { weights, basis } = tables();
  const [weightTable, basisTable] = [uniformArray<'vec4'>(weights, 'vec4'), uniformArray<'vec4'>(basis, 'vec4')];
  const sin2 = c.mul(c).oneMinus().toVar();
  const c2 = sqrt(max(sin2.div(n.mul(n)).oneMinus(), 0)).toVar();
  const [outerS, outerP] = [c.sub(n.mul(c2)).div(c.add(n.mul(c2))), n.mul(c).sub(c2).div(n.mul(c).add(c2))].map((r) =>
    r.toVar(),
  );
  const inner = (F: Float): readonly [Float, Float] => {
    const root = sqrt(clamp(F, 0, 0.9999)).toVar();
    const below = root.add(1).div(root.oneMinus()).toVar();
    const c3 = sqrt(max(sin2.div(below.mul(below)).oneMinus(), 0)).toVar();
    const s = n
      .mul(c2)
      .sub(below.mul(c3))
      .div(n.mul(c2).add(below.mul(c3)));
    const p = below
      .mul(c2)
      .sub(n.mul(c3))
      .div(below.mul(c2).add(n.mul(c3)));
    return [s.toVar(), p.toVar()];
  };
  const way = n
    .mul(thickness)
    .mul(c2)
    .mul(4 * Math.PI)
    .toVar();
  const sum = vec3(0).toVar();
  loopTimes(int(SAMPLES), (k) => {
    const at = (weightTable.element(k) as Vec4).toVar();
    const cosPhi = cos(way.div(at.w)).toVar();
    const [s, p] = inner(dot((basisTable.element(k) as Vec4).xyz, F0.xyz));
    sum.addAssign(
      at.xyz.mul(
        interfering(outerS, s, cosPhi)
          .add(interfering(outerP, p, cosPhi))
          .mul(0.5),
      ),
    );
  });
  const [s, p] = inner(F0.w);
  return {
    rgb: max(sum, 0).toVar(),
    invisible: incoherent(outerS, s).add(incoherent(outerP, p)).mul(0.5).toVar(),
  };
}

function interfering(a: Float, b: Float, cosPhi: Float): Float {
  const cross = a.mul(b).mul(2).mul(cosPhi).toVar();
  const squares = a.mul(a).mul(b.mul(b));
  return a.mul(a).add(b.mul(b)).add(cross).div(squares.add(1).add(cross));
}

/** Its mean over all phases. */
function incoherent(a: Float, b: Float): Float {
  const [A, B] = [a.mul(a).toVar(), b.mul(b).toVar()];
  return A.add(B)
    .sub(A.mul(B).mul(2))
    .div(max(float(1).sub(A.mul(B)), 1e-6));
}
