import { dot, Fn, float, min, mix, vec2, vec3, vec4 } from 'three/tsl';
import type { Float, Vec3 } from '../../shaders/types.ts';
import { type BrdfNodes, brdfOf, environmentBrdf, schlick } from '../brdf/brdf.ts';
import type { LobeTable } from '../brdf/lobeTable.ts';
import type { ColorPipeline, RadianceAccumulator } from '../color/radiance.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import type { Environment } from '../lights/environment.ts';
import type { RestFrameNodes } from '../lights/restFrame.ts';
import { beginShading, type ShadedSurface } from '../shading/shade.ts';
import type { LightVisibility } from '../shadows/distant/parallelReceiver.ts';
import { type FuzzNodes, fuzzOf } from './fuzz.ts';
import { type GroovesHere, groovesOf } from './grooves.ts';
import { type FilmNodes, filmReflectance } from './thinFilm.ts';

/** What layers a surface has at a fragment; the same formulas as in src/reference/materials/brdf.ts. */
export interface SurfaceLayers {
  readonly specular?: { readonly factor: Float; readonly color: Vec3 };
  readonly film?: FilmNodes & { readonly factor: Float };
  readonly fuzz?: FuzzNodes;
  readonly grooves?: GroovesHere;
  /** The share that passes, and the radiance of what is seen through it by the observer. */
  readonly clear?: { readonly share: Float; readonly behind: (view: GlassView) => Vec3 };
  readonly coat?: { readonly factor: Float; readonly roughness: Float; readonly normal: Vec3 };
}

/** A surface that is looked through, in its rest frame. */
export interface GlassView {
  readonly rest: RestFrameNodes;
  readonly N: Vec3;
  readonly V: Vec3;
}

/** F₀ of a varnish, of a refractive index of 1.5. */
const COAT_F0 = 0.04;

/** Radiance of a layered surface that reaches the observer: what `shade` of shading/shade.ts is for a plain one. */
export const shadeLayered = (
  surface: ShadedSurface,
  layers: SurfaceLayers,
  environment: Environment,
  uniforms: FrameUniforms,
  pipeline: ColorPipeline,
  shadows?: LightVisibility,
): Vec3 =>
  Fn(() => {
    const { rest, N, V, accumulator, albedo, lit } = beginShading(surface, uniforms, pipeline, shadows);
    const { specular, coat: varnish, film, fuzz: fibres, grooves, clear } = layers;
    const tinted = specular && {
      F0: accumulator
        .filter(min(specular.color.mul(surface.F0), 1))
        .mul(specular.factor)
        .toVar(),
      F90: specular.factor,
    };
    const grooved = grooves && groovesOf(grooves, surface.roughness, N);
    const parameters = { ...surface, ...(tinted && { tinted }), ...(grooved && { roughness: grooved.mean }) };
    const bare = { ...brdfOf(albedo, parameters, N, V, environment.lobes), ...(grooved && { grooves: grooved }) };
    const whole = film ? filmed(bare, film, accumulator.filter) : bare;
    const share = clear?.share.mul(surface.metallic.oneMinus()).toVar();
    const base = share ? { ...whole, diffuse: whole.diffuse.mul(share.oneMinus()).toVar() } : whole;
    const coat = varnish && coatOf(varnish, V, environment.lobes);
    const varnished = coat && environmentBrdf(coat).x.oneMinus().toVar();
    const fuzz = fibres && fuzzOf(fibres, N, V, environment.lobes, accumulator.filter);
    const passed = varnished && fuzz ? varnished.mul(fuzz.passed).toVar() : (varnished ?? fuzz?.passed);
    environment.addReflected({ ...lit, brdf: passed ? dimmed(base, passed) : base }, accumulator);
    if (fuzz)
      environment.addReflected({ ...lit, brdf: varnished ? dimmed(fuzz.brdf, varnished) : fuzz.brdf }, accumulator);
    if (coat) environment.addReflected({ ...lit, brdf: coat }, accumulator);
    const { emission } = surface;
    accumulator.addEmitted(passed ? emission.rgb.mul(passed) : emission.rgb);
    accumulator.addGlow(passed ? { ...emission, luminance: emission.luminance.mul(passed) } : emission);
    if (!clear || !share) return accumulator.total();
    const through = clear.behind({ rest, N, V }).mul(share.mul(environmentBrdf(base).x.oneMinus()));
    return accumulator.total().add(passed ? through.mul(passed) : through);
  })();

const coatOf = (
  { factor, roughness, normal }: NonNullable<SurfaceLayers['coat']>,
  V: Vec3,
  lobes: LobeTable,
): BrdfNodes => {
  const tinted = { F0: vec4(factor.mul(COAT_F0)), F90: factor };
  return brdfOf(vec4(0), { metallic: float(0), F0: factor, roughness, tinted }, normal, V, lobes);
};

/** A surface under a thin film. Light from all round is reflected as from the angle of view. */
function filmed(
  brdf: BrdfNodes,
  film: NonNullable<SurfaceLayers['film']>,
  filter: RadianceAccumulator['filter'],
): BrdfNodes {
  const { F0, F90 } = brdf;
  const reflectance = (cos: Float) => {
    const { rgb, invisible } = filmReflectance(cos, film, F0);
    return { seen: filter(rgb, vec2(invisible)), mean: dot(rgb, vec3(1 / 3)) };
  };
  const { seen, mean } = reflectance(brdf.NV);
  return {
    ...brdf,
    F0: mix(F0, seen, film.factor).toVar(),
    F90: mix(F90, mean, film.factor).toVar(),
    fresnel: (VH) => mix(schlick(F0, F90, VH), reflectance(VH).seen, film.factor),
  };
}

/** What is below another layer that lets this fraction through. */
const dimmed = (brdf: BrdfNodes, passed: Float): BrdfNodes => ({
  ...brdf,
  diffuse: brdf.diffuse.mul(passed).toVar(),
  F0: brdf.F0.mul(passed).toVar(),
  F90: brdf.F90.mul(passed).toVar(),
  ...(brdf.fresnel && { fresnel: (VH: Float) => brdf.fresnel!(VH).mul(passed) }),
  ...(brdf.specular && { specular: (L: Vec3, NL: Float) => brdf.specular!(L, NL).mul(passed) }),
});
