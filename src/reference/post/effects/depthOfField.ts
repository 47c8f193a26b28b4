import { DEPTH_OF_FIELD_SAMPLING, EFFECTS } from '../../../scene/frameGraph/effects.ts';
import { FloatImage, type GBufferReader } from './effectInput.ts';

/** Least radius of a blur disc [px]: that of a disc of one pixel's area. */
const MIN_RADIUS = Math.sqrt(1 / Math.PI);
/** As a fraction of a full turn. */
const GOLDEN_ANGLE = (3 - Math.sqrt(5)) / 2;
/** Radius in cells of the search for the widest blur. */
const CELL_REACH = Math.ceil(EFFECTS['depth-of-field'].args[2].max / DEPTH_OF_FIELD_SAMPLING.cell);

/**
 * A thin lens at rest in the observer's frame: a point at the depth z along the axis becomes a disc of radius ρ = ½ A |1/f − 1/z| F [px], A the
 * aperture, f the focus distance, F the focal length in pixels. z belongs to the apparent distance |Δx′|: in the observer's frame light comes from
 * there, and its wave front has that curvature, wherever the source is now. Each pixel gathers the discs that reach it, with the light L/(πρ²);
 * farther pixels spread over it no wider than its own blur. arg1: f [m]; arg2: A [mm]; arg3: the largest ρ [px]. docs/physics.md §8.4.
 */
export function depthOfField(frame: GBufferReader, [focus = 1, aperture = 0, most = 0]: readonly number[]): FloatImage {
  const scale = ((aperture / 1000) * (frame.image.height / (2 * frame.frustum.tanY))) / 2;
  const lens = frame.image.map((x, y) => {
    const rho = scale * (1 / focus - inverseDepth(frame, x, y));
    return [...frame.image.at(x, y), Math.min(Math.max(rho, -most), most)];
  }, 4);
  const soft = lens.map((x, y) => softened(lens, x, y), 4);
  const reach = widest(widest(cellsOf(lens), 1, 0), 0, 1);
  return lens.map((x, y) => gathered(soft, reach, x, y));
}

/** 1/z; 0 where no surface is. */
function inverseDepth(frame: GBufferReader, x: number, y: number): number {
  if (!frame.isCovered(x, y)) return 0;
  const [tx, ty] = frame.tangents(x, y);
  return Math.sqrt(1 + tx * tx + ty * ty) / frame.depth(x, y);
}

/** Blurred pixels filtered by a 3 × 3 binomial over neighbours of similar blur, so that no spot is missed between samples. */
function softened(lens: FloatImage, x: number, y: number): readonly number[] {
  const [r, g, b, own] = lens.at(x, y) as [number, number, number, number];
  const sum = [r, g, b];
  const amount = Math.min(Math.max(Math.abs(own) - 1, 0), 1);
  let total = 1;
  for (let j = -1; j <= 1; j++)
    for (let i = -1; i <= 1; i++) {
      if (i === 0 && j === 0) continue;
      const texel = lens.at(x + i, y + j);
      const alike = Math.min(Math.max(2 - Math.abs(texel[3]! - own), 0), 1);
      const weight = (i * j === 0 ? 0.5 : 0.25) * amount * alike;
      for (let c = 0; c < 3; c++) sum[c]! += weight * texel[c]!;
      total += weight;
    }
  return [...sum.map((value) => value / total), own];
}

/** The greatest |ρ| of each cell. */
function cellsOf(lens: FloatImage): FloatImage {
  const { cell } = DEPTH_OF_FIELD_SAMPLING;
  return FloatImage.of(Math.ceil(lens.width / cell), Math.ceil(lens.height / cell), 1, (x, y) => {
    let most = 0;
    for (let j = 0; j < cell; j++)
      for (let i = 0; i < cell; i++) most = Math.max(most, Math.abs(lens.at(cell * x + i, cell * y + j)[3]!));
    return [most];
  });
}

/** The greatest |ρ| that reaches a cell from cells along one axis. */
function widest(cells: FloatImage, dx: number, dy: number): FloatImage {
  return cells.map((x, y) => {
    let most = 0;
    for (let k = -CELL_REACH; k <= CELL_REACH; k++) {
      const rho = cells.at(x + k * dx, y + k * dy)[0]!;
      if (rho >= DEPTH_OF_FIELD_SAMPLING.cell * (Math.abs(k) - 1)) most = Math.max(most, rho);
    }
    return [most];
  }, 1);
}

/** Gathers samples distributed uniformly over a disc (Vogel 1979). */
function gathered(lens: FloatImage, reach: FloatImage, x: number, y: number): readonly number[] {
  const [r, g, b, own] = lens.at(x, y) as [number, number, number, number];
  const R = reach.at(Math.floor(x / DEPTH_OF_FIELD_SAMPLING.cell), Math.floor(y / DEPTH_OF_FIELD_SAMPLING.cell))[0]!;
  const sampleCount = Math.min(Math.max(Math.ceil(R * R), 16), DEPTH_OF_FIELD_SAMPLING.samples);
  const density = (R * R) / sampleCount;
  let weight = 1 / Math.max(Math.abs(own), MIN_RADIUS) ** 2 / Math.PI;
  const sum = [r * weight, g * weight, b * weight];
  for (let i = 0; R >= 0.5 && i < sampleCount; i++) {
    const away = R * Math.sqrt((i + 0.5) / sampleCount);
    const angle = 2 * Math.PI * ((i * GOLDEN_ANGLE) % 1);
    const dx = Math.floor(away * Math.cos(angle) + 0.5);
    const dy = Math.floor(away * Math.sin(angle) + 0.5);
    const texel = lens.at(x + dx, y + dy);
    const signed = texel[3]!;
    const rho = signed > own ? Math.min(Math.abs(signed), Math.abs(own)) : Math.abs(signed);
    const covers = Math.min(Math.max(rho - away + 1, 0), 1);
    const contribution = (density * covers) / Math.max(rho, MIN_RADIUS) ** 2;
    for (let c = 0; c < 3; c++) sum[c]! += contribution * texel[c]!;
    weight += contribution;
  }
  return sum.map((value) => value / weight);
}
