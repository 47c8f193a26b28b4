import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { sampleBoundingBox, sampleBoundingSphere } from '../../../../scene/bounds/bounds.ts';
import { objectBounds } from '../../../../scene/bounds/sceneBounds.ts';
import { fastestVertex, vertexPositions, vertexWorldLine } from '../../../../scene/motion/motion.ts';
import { isStreamed, normalsAt, pointsAt } from '../../../../scene/streaming/samplePoints.ts';
import { InputError, type SampledPointsMotion, type Scene, type SceneObject } from '../../../../scene/types.ts';
import { validate } from '../../../../scene/validation/validate.ts';
import { type FileSource, memorySource } from '../../../files/fileSource.ts';
import { RangedFile } from '../../../files/rangedFile.ts';
import { openScene } from '../../../open.ts';
import { packUsdz } from '../../write/packUsdz.ts';

const C = 299_792_458;
const cache = new Uint8Array(readFileSync(new URL('../../fixtures/caches.usdc', import.meta.url)));
const entry = 'caches.usdc';
const opened = (source: FileSource, sampleMemory?: number, file = entry): Promise<Scene> =>
  openScene(source, file, { subdivision: 0, ...(sampleMemory === undefined ? {} : { sampleMemory }) });
const deforming = ({ motion }: SceneObject): SampledPointsMotion => {
  if (motion.kind !== 'sampled-points') throw new Error(motion.kind);
  return motion;
};
const inMemory = await opened(memorySource({ [entry]: cache }));
const streamed = await opened(memorySource({ [entry]: cache }), 0);

/** Undersampling is only reported for samples in memory. */
const said = ({ diagnostics }: Scene) => diagnostics.filter(({ code }) => code !== 'usd.between-samples');

describe('a streamed point cache', () => {
  it('is streamed if it exceeds the memory budget', () => {
    expect(inMemory.objects.map((object) => isStreamed(deforming(object).points))).toEqual(Array(5).fill(false));
    expect(streamed.objects.map((object) => isStreamed(deforming(object).points))).toEqual(Array(5).fill(true));
    expect(said(streamed)).toEqual(said(inMemory));
  });

  it('is drawn as its polygons, which is reported', async () => {
    const { objects, diagnostics } = await openScene(memorySource({ [entry]: cache }), entry, { sampleMemory: 0 });
    expect(isStreamed(deforming(objects[0]).points)).toBe(true);
    expect(diagnostics.filter(({ code }) => code === 'usd.subdivision')).toHaveLength(5);
  });

  it('is read whole where it fits', async () => {
    const some = await opened(memorySource({ [entry]: cache }), 24 * 400 * 6 + 1);
    expect(some.objects.map((object) => isStreamed(deforming(object).points))).toEqual([false, true, true, true, true]);
  });

  describe.each(inMemory.objects.map((object, i) => [object.path, object, streamed.objects[i]] as const))(
    '%s',
    (_, known, left) => {
      const [own, other] = [deforming(known), deforming(left)];

      it('has the same samples and normals, to the bit', () => {
        expect(left.mesh).toEqual(known.mesh);
        expect([other.times, other.origin]).toEqual([own.times, own.origin]);
        for (const k of own.times.keys()) {
          expect(pointsAt(other, k)).toEqual(pointsAt(own, k));
          expect(normalsAt(other, k)).toEqual(normalsAt(own, k));
        }
      });

      it('has the same bounds, speeds and world lines', () => {
        for (const k of own.times.keys()) {
          expect(sampleBoundingBox(other, k)).toEqual(sampleBoundingBox(own, k));
          expect(sampleBoundingSphere(other, k)).toEqual(sampleBoundingSphere(own, k));
          expect(objectBounds(left, own.times[k], C)).toEqual(objectBounds(known, own.times[k], C));
        }
        expect(fastestVertex(left, C)).toEqual(fastestVertex(known, C));
        expect(vertexWorldLine(left, 7, C)).toEqual(vertexWorldLine(known, 7, C));
        expect(vertexPositions(left, 0.03, C)).toEqual(vertexPositions(known, 0.03, C));
      });
    },
  );

  it('is checked for superluminal motion', () => {
    expect(validate(streamed, 1)).toEqual(validate(inMemory, 1));
    expect(validate(streamed, 1).map(({ code }) => code)).toContain('motion.superluminal');
  });

  it('streams from a package, too', async () => {
    const zip = packUsdz(new Map([['inside.usdc', cache]]));
    const { objects } = await opened(memorySource({ 'a.usdz': zip }), 0, 'a.usdz');
    expect(isStreamed(deforming(objects[0]).points)).toBe(true);
    expect(pointsAt(deforming(objects[0]), 3)).toEqual(pointsAt(deforming(inMemory.objects[0]), 3));
  });

  it('reports progress', async () => {
    const parts: number[] = [];
    await openScene(memorySource({ [entry]: cache }), entry, {
      subdivision: 0,
      sampleMemory: 0,
      progress: (part) => parts.push(part),
    });
    expect(parts.slice(0, 6)).toEqual([1 / 6, 2 / 6, 3 / 6, 4 / 6, 5 / 6, 1]);
  });
});

describe('damage', () => {
  const ranged = (bytes: Uint8Array): FileSource => ({
    read: async () => bytes,
    open: async (path) => new RangedFile({ name: path, handle: bytes }, bytes.length),
  });
  /** Offset of a sample of the first mesh, after its length. */
  const sampleAt = (k: number): number => {
    const { points } = deforming(streamed.objects[0]);
    if (!isStreamed(points)) throw new Error('in memory');
    return points.samples[k].points.before.at;
  };
  const refused = async (bytes: Uint8Array): Promise<InputError> => {
    const thrown = await opened(ranged(bytes), 0).catch((error: unknown) => error);
    if (thrown instanceof InputError) return thrown;
    throw new Error(`not refused: ${thrown}`);
  };

  it('an array longer than the file is rejected without reading', async () => {
    const damaged = cache.slice();
    new DataView(damaged.buffer).setBigUint64(sampleAt(0) - 8, 2n ** 30n, true);
    expect((await refused(damaged)).message).toMatch(
      /caches\.usdc<\/Plain\.points> timeSamples .*12884901888 bytes.*cut off or damaged/,
    );
  });

  it('a truncated file is rejected', async () => {
    for (const part of [0.1, 0.5, 0.9, 0.999])
      expect((await refused(cache.subarray(0, cache.length * part))).diagnostic.severity).toBe('error');
  });

  it('points that are non-finite at one sample are skipped, as in memory', async () => {
    const damaged = cache.slice();
    new DataView(damaged.buffer).setFloat32(sampleAt(5) + 40, Number.NaN, true);
    const [left, known] = [await opened(ranged(damaged), 0), await opened(ranged(damaged))];
    expect(said(left)).toEqual(said(known));
    expect(left.diagnostics.map(({ code }) => code)).toContain('file.not-finite');
    expect(left.objects[0].mesh.indices).toEqual(known.objects[0].mesh.indices);
    expect(validate(left, C)).toEqual([]);
    const [own, other] = [deforming(known.objects[0]), deforming(left.objects[0])];
    for (const k of own.times.keys()) {
      expect(pointsAt(other, k)).toEqual(pointsAt(own, k));
      expect(normalsAt(other, k)!.every(Number.isFinite)).toBe(true);
    }
  });
});
