import type { GraphDocument } from '../../src/graph/document/document.ts';
import { applyCommand, type Command } from '../../src/graph/edits/commands.ts';
import { groupCommand } from '../../src/graph/edits/group.ts';
import { nodeLibrary } from '../../src/nodes/library.ts';
import { flyCommand, newProject } from '../../src/nodes/project/projectCommands.ts';
import { add, connect, edited, set } from './graphKit.ts';

/** A file under a panorama, with parameters of the node. */
export const panoramaProject = (params: Readonly<Record<string, number | string | boolean>> = {}): GraphDocument =>
  edited(
    newProject('box.usda'),
    add('panorama', 'panorama', [0, 400]),
    ...Object.entries(params).map(([param, value]) => set('panorama', param, value)),
    connect('panorama.lights', 'scene.lights.1'),
  );

/** A house that passes at γ = 1.25, with exposure chosen by nodes: every utility node affects the picture. */
export function utilityProject(): GraphDocument {
  const flying = applyCommand(newProject('a.usda'), flyCommand(newProject('a.usda'), '/House', 0)).document;
  const nodes: readonly Command[] = [
    ...['number', 'math', 'vector-math', 'compare', 'switch', 'vector', 'color', 'separate', 'text', 'reroute'].map(
      (type, i) => add(type, type, [i * 200, 400]),
    ),
    set('number', 'number', 1.25),
    set('math', 'operation', 'beta-of-gamma'),
    set('vector-math', 'operation', 'normalize'),
    set('compare', 'relation', 'less'),
    set('compare', 'b', 0.5),
    set('vector', 'x', 1),
    set('vector', 'y', 2),
    set('text', 'text', '/cam'),
    { kind: 'set-param', node: 'color', param: 'color', value: [0, 0.25, 4] },
  ];
  const edges: readonly Command[] = [
    connect('number.number', 'math.a'),
    connect('math.number', 'reroute.in'),
    connect('reroute.out', 'fly1.speed'),
    connect('math.number', 'compare.a'),
    connect('compare.number', 'switch.second'),
    connect('color.color', 'switch.b'),
    connect('vector.vector', 'switch.a'),
    connect('switch.out', 'separate.vector'),
    connect('separate.y', 'toneMap.exposure'),
    connect('text.text', 'camera.camera'),
    connect('vector.vector', 'vector-math.a'),
    connect('vector-math.vector', 'fly1.direction'),
  ];
  const whole = edited(flying, ...nodes, ...edges);
  return edited(whole, groupCommand(whole, { nodes: ['math', 'compare'] }, 'Speed', nodeLibrary).command);
}
