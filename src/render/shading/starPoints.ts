import { attribute, exp, Fn, float, length, pow, round, uniform, vec4 } from 'three/tsl';
import {
  AdditiveBlending,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LessEqualDepth,
  Mesh,
  type Node,
  NodeMaterial,
  PlaneGeometry,
  Scene,
  Vector2,
} from 'three/webgpu';
import { POINT_SPREAD } from '../../scene/stars/pointSpread.ts';
import { projectStars } from '../../scene/stars/projectStars.ts';
import type { NightSky } from '../../scene/types.ts';
import type { RenderSettings, ViewPoint } from '../../scene/view/view.ts';
import type { Float } from '../../shaders/types.ts';
import type { Gpu } from '../gpu/device.ts';
import type { FrameUniforms } from '../gpu/frameUniforms.ts';
import { blendedRange, type LightRange, limitLight } from '../gpu/lightRange.ts';

/** The stars of a sky as points a few pixels wide, hidden by surfaces. Their light is computed in f64 for each picture. */
export class StarPoints {
  /** Drawn over the light of the sky. */
  readonly scene = new Scene();
  private readonly sky: NightSky;
  private readonly geometry = new InstancedBufferGeometry();
  private readonly material: NodeMaterial;
  /** Positions in the picture (NDC, −1 … 1), and half the side of the stars' squares [px]. */
  private readonly places: InstancedBufferAttribute;
  private readonly lights: InstancedBufferAttribute;
  private readonly size = uniform(new Vector2(1, 1));

  constructor(sky: NightSky, uniforms: FrameUniforms, gpu: Gpu) {
    this.sky = sky;
    const count = sky.stars.temperatures.length;
    this.places = new InstancedBufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    this.lights = new InstancedBufferAttribute(new Float32Array(3 * count), 3).setUsage(DynamicDrawUsage);
    const square = new PlaneGeometry(2, 2);
    this.geometry.setIndex(square.getIndex());
    this.geometry.setAttribute('position', square.getAttribute('position'));
    this.geometry.setAttribute('starPlace', this.places);
    this.geometry.setAttribute('starLight', this.lights);
    this.material = starMaterial(uniforms, this.size, gpu.renderer.reversedDepthBuffer, blendedRange(gpu));
    const mesh = new Mesh(this.geometry, this.material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
  }

  update(view: ViewPoint, settings: RenderSettings, width: number, height: number): void {
    const count = projectStars(this.sky, view, settings, width, height, {
      positions: this.places.array as Float32Array,
      radiances: this.lights.array as Float32Array,
    });
    this.geometry.instanceCount = count;
    this.size.value.set(width, height);
    this.places.needsUpdate = true;
    this.lights.needsUpdate = true;
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}

function starMaterial(
  { jitter }: FrameUniforms,
  size: Node<'vec2'>,
  reversed: boolean,
  range: LightRange,
): NodeMaterial {
  const material = new NodeMaterial();
  material.name = 'stars';
  const place = attribute<'vec3'>('starPlace', 'vec3');
  const middle = place.xy.sub(jitter).mul(0.5).add(0.5).mul(size);
  // Corners are on whole pixels: a rasterizer would round others, and the interpolated varyings with them.
  const corner = round(middle.add(attribute<'vec3'>('position', 'vec3').xy.mul(place.z))).toVar();
  const pixels = corner.sub(middle);
  // On the far plane, as the pass over the sky (fullScreenPass.ts).
  material.vertexNode = vec4(corner.div(size).mul(2).sub(1), 0, 1);
  if (!reversed) material.depthNode = float(1);
  const light = attribute<'vec3'>('starLight', 'vec3').toVarying('v_starLight');
  const spread = light.mul(pointSpread(length(pixels.toVarying('v_starPixels'))));
  material.fragmentNode = Fn(() => vec4(limitLight(spread, range.max), 1))();
  material.depthFunc = LessEqualDepth;
  material.depthWrite = false;
  material.transparent = true;
  material.blending = AdditiveBlending;
  return material;
}

/** `pointSpread` of scene/stars/pointSpread.ts. */
function pointSpread(r: Float): Float {
  const { core, wings, reach, fall } = POINT_SPREAD;
  const gauss = exp(r.mul(r).mul(-1 / (2 * core * core))).mul((1 - wings) / (2 * Math.PI * core * core));
  const moffat = pow(
    r
      .mul(r)
      .div(reach * reach)
      .add(1),
    -fall,
  ).mul((wings * (fall - 1)) / (Math.PI * reach * reach));
  return gauss.add(moffat);
}
