import { describe, expect, it } from 'vitest';
import { projects } from '../../examples/projects/index.ts';
import { validateDocument } from '../../src/graph/analysis/validate.ts';
import type { GraphDocument } from '../../src/graph/document/document.ts';
import { applyCommand } from '../../src/graph/edits/commands.ts';
import { groupCommand } from '../../src/graph/edits/group.ts';
import { nodeLibrary } from '../../src/nodes/library.ts';
import { captureCommand, isCaptured, removeCaptureCommand } from '../../src/nodes/project/captureCommands.ts';
import { nodesFeedingOutput } from '../../src/nodes/project/outputChain.ts';
import { newProject } from '../../src/nodes/project/projectCommands.ts';

const captured = (document: GraphDocument) => applyCommand(document, captureCommand(document)).document;
const drawn = (document: GraphDocument) => applyCommand(document, removeCaptureCommand(document)).document;
const feeding = (document: GraphDocument, type: string) =>
  nodesFeedingOutput(document).filter((node) => node.type === type);

describe('what a project shows', () => {
  it('is taken from a capture, and drawn again as before', () => {
    const before = newProject('a.usda');
    const after = captured(before);
    expect(isCaptured(before)).toBe(false);
    expect(isCaptured(after)).toBe(true);
    expect(after.edges['capture.view']!.from).toEqual({ node: 'camera', output: 'view' });
    expect(after.edges['rasterize.view']!.from).toEqual({ node: 'capture', output: 'view' });
    expect(validateDocument(after, nodeLibrary)).toEqual([]);
    expect(drawn(after)).toEqual(before);
  });

  it('by one capture for several rasterizers of a view, and none for those that show no light', () => {
    const layers = projects['texture-hall']!();
    const one = captured(drawn(layers));
    expect(feeding(one, 'capture')).toHaveLength(1);
    expect(feeding(one, 'relativity-rasterize')).toHaveLength(2);
    const comparison = captured(projects.comparison!());
    expect(comparison.edges['ordinary.view']!.from.node).toBe('camera');
  });

  it('inside a group, and through captures in a row', () => {
    const before = newProject('a.usda');
    const { command } = groupCommand(before, { nodes: ['rasterize', 'lighting'] }, 'Picture', nodeLibrary);
    const grouped = applyCommand(before, command).document;
    const inside = captured(grouped);
    expect(feeding(inside, 'capture')).toHaveLength(1);
    expect(validateDocument(inside, nodeLibrary)).toEqual([]);
    expect(drawn(inside)).toEqual(grouped);
    const twice = captured(captured(before));
    expect(feeding(twice, 'capture')).toHaveLength(2);
    expect(drawn(twice)).toEqual(before);
  });
});
