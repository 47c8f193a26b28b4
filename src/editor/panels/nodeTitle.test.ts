import { expect, it } from 'vitest';
import { newProject } from '../../nodes/project.ts';
import { nodeTitle, shownTitle } from './nodeTitle.ts';

it('a node is called as the person says, else after its kind; what is no node is called nothing', () => {
  const project = newProject('a.usda');
  expect(nodeTitle(project, 'falseColour')).toBeUndefined();
  expect(shownTitle(project, 'falseColour')).toBe('node.falseColor');
  const { falseColour } = project.nodes;
  const named = { ...project, nodes: { ...project.nodes, falseColour: { ...falseColour!, title: 'Bands' } } };
  expect([nodeTitle(named, 'falseColour'), shownTitle(named, 'falseColour')]).toEqual(['Bands', 'Bands']);
  expect(shownTitle(project, '/World/Cube')).toBeUndefined();
});
