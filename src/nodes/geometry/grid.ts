import { grid } from '../../scene/primitives.ts';
import { axisParam, definePrimitive, metres, pieces } from './primitive.ts';

/** A flat rectangle of cells, seen from both sides. */
export const gridNode = definePrimitive({
  id: 'grid',
  title: 'node.grid',
  help: 'node.grid.help',
  name: 'Grid',
  params: {
    width: metres('param.width', 10),
    length: metres('param.length', 10),
    columns: pieces('param.columns', 10, 1, 1000),
    rows: pieces('param.rows', 10, 1, 1000),
    axis: axisParam,
  },
  mesh: ({ width, length, columns, rows, axis }) => grid(width, length, columns, rows, axis as 'Y'),
});
