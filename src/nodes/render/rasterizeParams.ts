import type { ParamSpec } from '../../graph/nodeType.ts';

/** Parameters of all rasterizer nodes. */
export const rasterizeParams = {
  antialiasing: {
    kind: 'boolean',
    title: 'param.antialiasing',
    help: 'param.antialiasing.help',
    default: true,
  },
  grid: { kind: 'boolean', title: 'param.grid', help: 'param.grid.help', default: false },
} as const satisfies Readonly<Record<string, ParamSpec>>;
