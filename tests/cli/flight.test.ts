import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { decode } from 'fast-png';
import { describe, expect, it } from 'vitest';
import { serializeDocument } from '../../src/graph/document/serialize.ts';
import { edited, set } from '../support/graphKit.ts';
import { savingProject } from '../support/savingGraph.ts';
import { slowlight } from './program.ts';

const folder = mkdtempSync(join(tmpdir(), 'slowlight-flight-'));
const at = (name: string): string => join(folder, name);
const SPHERE = new URL('../../examples/sphere.usdc', import.meta.url).pathname;

async function done(...args: string[]): Promise<string> {
  const { code, out, err } = await slowlight(...args);
  expect(code, err).toBe(0);
  return out;
}

async function refused(...args: string[]): Promise<string> {
  const { code, err } = await slowlight(...args);
  expect(code).toBeGreaterThan(0);
  return err;
}

describe('slowlight flight', () => {
  it('plans a trip at 1 g, which closed forms confirm; cuts it and joins the parts', async () => {
    const d = 4.068e16;
    const c = 299_792_458;
    const report = JSON.parse(
      await done('flight', 'trip', '--to', `0,0,-${d}`, '-o', at('star.flight.json'), '--json'),
    );
    const tau = ((2 * c) / 9.80665) * Math.acosh(1 + (9.80665 * d) / (2 * c * c));
    expect(Math.abs(report.pilotTime / tau - 1)).toBeLessThan(1e-12);
    expect(Math.abs(report.legs[0].worldTime / Math.sqrt((d / c) ** 2 + (4 * d) / 9.80665) - 1)).toBeLessThan(1e-12);
    expect(await done('flight', 'inspect', at('star.flight.json'))).toContain('(3.5');

    const half = String(tau / 2);
    await done('flight', 'cut', at('star.flight.json'), '--to', half, '-o', at('a.flight.json'));
    await done('flight', 'cut', at('star.flight.json'), '--from', half, '-o', at('b.flight.json'));
    await done('flight', 'splice', at('a.flight.json'), at('b.flight.json'), '-o', at('both.flight.json'));
    const both = JSON.parse(await done('flight', 'inspect', at('both.flight.json'), '--json'));
    expect(both.legs).toHaveLength(2);
    expect(Math.abs(both.pilotTime / tau - 1)).toBeLessThan(1e-12);
    expect(both.legs[0].to[2] / d).toBeCloseTo(-0.5, 12);
    expect(both.legs[1].to[2] / d).toBeCloseTo(-1, 12);
  });

  it('says what is wrong with a file, and with flags', async () => {
    writeFileSync(at('bad.flight.json'), readFileSync(at('star.flight.json'), 'utf8').replace('"free"', '"loose"'));
    expect(await refused('flight', 'inspect', at('bad.flight.json'))).toMatch(
      /bad\.flight\.json: legs\.0\.lock: expected/,
    );
    expect(await refused('flight', 'inspect', at('none.flight.json'))).toContain('none.flight.json');
    expect(await refused('flight', 'trip', '--to', '0,0,0', '-o', at('x.flight.json'))).toContain('nothing to fly');
    expect(await refused('flight', 'trip', '--to', '1,0,0', '-o', at('x.json'))).toContain('.flight.json');
    const film = ['render', SPHERE, '--flight', at('star.flight.json')];
    expect(await refused(...film, '-o', at('x.png'), '--beta', '0,0,0.5')).toContain(
      '--beta says where the observer is',
    );
    expect(await refused(...film, '-o', at('x.png'), '--c', '10')).toContain('flown at 299792458');
    expect(await refused(...film, '-o', at('x.png'), '--time', '-1')).toContain('the flight lasts from 0 to');
  });

  it('tells of a flight that is faster than pictures', async () => {
    const trip = (d: number) => done('flight', 'trip', '--to', `0,0,${-d}`, '--c', '10', '-o', at('fast.flight.json'));
    const middle = async (): Promise<string> => {
      const { pilotTime } = JSON.parse(await done('flight', 'inspect', at('fast.flight.json'), '--json'));
      const film = ['render', SPHERE, '--flight', at('fast.flight.json'), '--time', String(pilotTime / 2)];
      const { code, err } = await slowlight(...film, '-o', at('fast.png'), '--size', '16x9', '--pipeline', 'reference');
      expect(code, err).toBe(0);
      return err;
    };
    // γ half way is 1 + ad/2c².
    await trip(1.9e4 * (100 / 9.80665));
    expect(await middle()).not.toContain('faster than pictures');
    await trip(2.1e4 * (100 / 9.80665));
    expect(await middle()).toContain('drawn as at γ = 10000');
  });

  it('is filmed by a project whose node names it, as by render --flight', async () => {
    const how = ['--acceleration', '5', '--c', '10', '-o', at('across.flight.json')];
    await done('flight', 'trip', '--from', '0,1,6', '--to', '1,1,4', ...how);
    const film = [
      ...[set('film', 'flight', 'across.flight.json'), set('film', 'spacing', 'proper')],
      ...[set('film', 'name', 'made.##.png'), set('film', 'fps', 2)],
    ];
    const project = at('film.slowlight.json');
    writeFileSync(project, serializeDocument(edited(savingProject(), ...film)));
    const rays = ['--pipeline', 'reference'];
    const { files } = JSON.parse(await done('render', project, '--folder', folder, '--json', ...rays));
    const made = files.filter((file: string) => /made\.\d\d\.png$/.test(file));
    expect(made.length).toBeGreaterThan(1);
    const flown = ['--flight', at('across.flight.json'), '--fps', '2', '--size', '64x48', '--samples', '1'];
    await done('render', project, '-o', at('flown.##.png'), ...flown, ...rays);
    for (const file of made)
      expect(readFileSync(file).equals(readFileSync(file.replace('made', 'flown'))), file).toBe(true);
  });

  it('films a flight: each frame is the picture of an observer there, with that velocity', async () => {
    const [a, c] = [5, 10];
    await done(
      'flight',
      'trip',
      '--from',
      '0,1.5,8',
      '--to',
      '0,1.5,-8',
      '--acceleration',
      `${a}`,
      '--c',
      `${c}`,
      '--start',
      '1',
      '-o',
      at('sphere.flight.json'),
    );
    // Where the observer is, is the same in both pipelines; this one starts sooner where there is no GPU.
    const size = ['--size', '48x32', '--pipeline', 'reference', '--samples', '1'];
    await done(
      'render',
      SPHERE,
      '--flight',
      at('sphere.flight.json'),
      '-o',
      at('f.##.png'),
      '--frames',
      '1:3',
      '--fps',
      '2',
      '--metering',
      'manual',
      ...size,
    );
    const film = ['render', SPHERE, '--flight', at('sphere.flight.json'), '-o', at('w.##.png'), '--spacing', 'world'];
    const world = JSON.parse(await done(...film, '--frames', '1:2', '--fps', '2', '--json', ...size));
    for (const [k, t] of [1.5, 2].entries()) expect(world.times[k]).toBeCloseTo(t, 9);
    for (const frame of [1, 3]) {
      const zeta = (a * frame) / 2 / c;
      const z = 8 - (c * c * (Math.cosh(zeta) - 1)) / a;
      const where = [
        '--time',
        `${1 + (c / a) * Math.sinh(zeta)}`,
        '--position',
        `0,1.5,${z}`,
        '--beta',
        `0,0,${-Math.tanh(zeta)}`,
      ];
      const look = ['--look-at', `0,1.5,${z - 1}`, '--c', `${c}`, '--metering', 'manual'];
      await done('render', SPHERE, '-o', at('one.png'), ...where, ...look, ...size);
      const [film, one] = [`f.0${frame}.png`, 'one.png'].map((name) => decode(readFileSync(at(name))).data);
      const steps = Array.from(film!, (value, i) => Math.abs(value - one![i]!));
      expect(Math.max(...steps)).toBeLessThanOrEqual(1);
    }
  });
});
