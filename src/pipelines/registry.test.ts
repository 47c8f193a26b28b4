import { describe, expect, it } from 'vitest';
import { IDENTITY } from '../math/quat.ts';
import { ZERO } from '../math/vec3.ts';
import { msg } from '../messages/message.ts';
import { makeScene } from '../scene/defaults.ts';
import { perspective } from '../scene/view/lenses/perspectiveLens.ts';
import { DEFAULT_SETTINGS } from '../scene/view/view.ts';
import type { PipelineHost } from './host.ts';
import { openSession } from './openSession.ts';
import { optionsByEffect, withDefaults } from './options.ts';
import type { Pipeline, PipelineSession } from './pipeline.ts';
import { AUTOMATIC_PIPELINES, interactivePipeline, PIPELINES, pipelineNamed } from './registry.ts';

describe('the list of pipelines', () => {
  it('has unique names, and each pipeline can draw', () => {
    expect(new Set(PIPELINES.map(({ id }) => id)).size).toBe(PIPELINES.length);
    for (const { id, open, openInteractive } of PIPELINES) {
      expect(open ?? openInteractive, id).toBeDefined();
      expect(pipelineNamed(id).id).toBe(id);
    }
    expect(() => pipelineNamed('none')).toThrow('none');
  });

  it('has one for the page, which needs a GPU, and a fallback without one', () => {
    expect(interactivePipeline().backends).not.toEqual([]);
    expect(AUTOMATIC_PIPELINES[0]).toBe(PIPELINES[0]);
    expect(AUTOMATIC_PIPELINES.some(({ backends }) => backends.length === 0)).toBe(true);
  });

  it('has defaults within the options’ ranges, and thread code for pipelines that use threads', () => {
    for (const { id, options, usesThreads, serveThread } of PIPELINES) {
      for (const [name, option] of Object.entries(options)) {
        if (option.kind === 'boolean' || option.default === undefined) continue;
        expect(option.default, name).toBeGreaterThanOrEqual(option.min);
        expect(option.default, name).toBeLessThanOrEqual(option.max);
      }
      expect(serveThread !== undefined, id).toBe(usesThreads);
    }
  });
});

it('a picture of more views than the pipeline draws is refused', async () => {
  const session: PipelineSession = {
    info: { pipeline: 'few' },
    render: async () => ({ pixels: new Uint8Array(), aovs: new Map() }),
    close: async () => {},
  };
  const few: Pipeline = { ...pipelineNamed('reference'), name: msg`small one`, maxViews: 2, open: async () => session };
  const request = {
    scenes: [makeScene({ name: '' })],
    size: { width: 1, height: 1 },
    speedOfLight: 1,
    options: {},
  } as const;
  const { render } = await openSession(few, request, {} as PipelineHost);
  const view = { t: 0, position: ZERO, u: ZERO, orientation: IDENTITY, lens: perspective(1) };
  const picture = { settings: DEFAULT_SETTINGS, samples: 1, pixels: true, aovs: [] };
  await expect(render({ ...picture, views: [view, view] })).resolves.toBeDefined();
  await expect(render({ ...picture, views: [view, view, view] })).rejects.toThrow(/^3 views .* small one .* up to 2$/);
});

describe('options', () => {
  const options = {
    threads: { kind: 'integer', min: 1, max: 8, help: '', changesPicture: false },
    bounces: { kind: 'integer', min: 0, max: 8, default: 2, help: '', changesPicture: true },
    mirrors: { kind: 'boolean', default: true, help: '', changesPicture: true },
  } as const;

  it('have their defaults if absent or undefined', () => {
    expect(withDefaults(options, { bounces: undefined })).toEqual({ threads: undefined, bounces: 2, mirrors: true });
    expect(withDefaults(options, { threads: 3, mirrors: false })).toEqual({ threads: 3, bounces: 2, mirrors: false });
  });

  it('that change the picture come first', () => {
    expect(optionsByEffect(options).map(([name]) => name)).toEqual(['bounces', 'mirrors', 'threads']);
  });
});
