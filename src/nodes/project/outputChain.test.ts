import { describe, expect, it } from 'vitest';
import { add, connect, edited, set } from '../../../tests/support/graphKit.ts';
import { groupCommand } from '../../graph/edits/group.ts';
import { nodeLibrary } from '../library.ts';
import { nearestToOutput, nodesFeedingOutput, outputNodeId, readNodeParams } from './outputChain.ts';
import {
  flyCommand,
  flyNodesIn,
  newProject,
  openFileCommand,
  removeFlightCommand,
  setParamCommand,
} from './projectCommands.ts';

const standard = newProject('a.usda');
const types = (document: typeof standard) => nodesFeedingOutput(document).map(({ type }) => type);

describe('the chain that leads to the output', () => {
  it('has the nearest node first, without unconnected ones', () => {
    const more = edited(standard, add('lonely', 'read', [0, 0]));
    expect(types(more)).toEqual([
      'output',
      'false-colour',
      'tone-map',
      'deferred-lighting',
      'relativity-rasterize',
      'scene-camera',
      'relativity-console',
      'scene',
      'retime',
      'read',
    ]);
    expect(readNodeParams(more)).toEqual({ read: { source: 'a.usda' } });
  });

  it('is found under any names, in groups, and not through muted nodes', () => {
    const { command } = groupCommand(standard, { nodes: ['read', 'retime'] }, 'File', nodeLibrary);
    const grouped = edited(standard, command);
    expect(nearestToOutput(grouped, 'read')?.id).toBe('group/read');
    expect(outputNodeId(grouped)).toBe('output');
    const quiet = edited(grouped, {
      kind: 'inside',
      group: 'group',
      command: { kind: 'mute', nodes: ['retime'], muted: true },
    });
    expect(types(quiet)).not.toContain('retime');
    expect(types(quiet)).toContain('read');
  });

  it('is empty without an output', () => {
    const without = edited(standard, { kind: 'remove-nodes', nodes: ['output'] });
    expect([outputNodeId(without), nodesFeedingOutput(without)]).toEqual([undefined, []]);
  });

  it('another scene is opened in the nearer of two file nodes', () => {
    const two = edited(
      standard,
      add('far', 'read', [0, 0]),
      add('turn', 'transform', [0, 0]),
      connect('far.geometry', 'turn.geometry'),
      add('near', 'read', [0, 0]),
      connect('turn.geometry', 'scene.geometry.2'),
      connect('near.geometry', 'scene.geometry.3'),
      set('near', 'source', 'near.usda'),
    );
    const opened = edited(two, openFileCommand(two, 'b.usda')!);
    expect(opened.nodes.near?.params).toEqual({ source: 'b.usda' });
    expect(opened.nodes.read?.params).toEqual({ source: 'a.usda' });
  });
});

describe('project edits by node type', () => {
  const { command } = groupCommand(standard, { nodes: ['console', 'camera'] }, 'Look', nodeLibrary);
  const grouped = edited(standard, command);

  it('opening another scene removes settings and texts of the last one, also in groups', () => {
    const before = edited(
      grouped,
      setParamCommand(grouped, 'group/console', 'speedOfLight', 5),
      {
        kind: 'describe',
        what: 'lookFor',
        value: 'the street',
      },
      {
        kind: 'set-marks',
        marks: [{ name: '1', time: 2, position: [0, 0, 0], properTime: 2, ownTime: 2, u: [0, 0, 0] }],
      },
    );
    expect(before.marks).toHaveLength(1);
    expect(before.groups.group?.nodes.console?.params).toEqual({ speedOfLight: 5 });
    const after = edited(before, openFileCommand(before, 'b.usda')!);
    expect(after.groups.group?.nodes.console?.params).toEqual({});
    expect([after.lookFor, after.marks]).toEqual([undefined, undefined]);
    expect(openFileCommand(edited(standard, { kind: 'remove-nodes', nodes: ['read'] }), 'b.usda')).toBeUndefined();
  });

  it('flights can be added at the camera’s node, and removed', () => {
    const one = edited(grouped, flyCommand(grouped, '/a', 0));
    const two = edited(one, flyCommand(one, '/b', 2));
    expect(flyNodesIn(two)).toEqual(['group/fly1', 'group/fly2']);
    const left = edited(two, removeFlightCommand(two, 'group/fly1'));
    expect(edited(left, removeFlightCommand(left, 'group/fly2'))).toEqual(grouped);
    expect(flyNodesIn(edited(two, openFileCommand(two, 'b.usda')!))).toEqual([]);
    const blind = edited(standard, { kind: 'remove-nodes', nodes: ['camera'] });
    expect(edited(blind, flyCommand(blind, '/a', 0))).toEqual(blind);
  });
});
