// @vitest-environment jsdom
import { MantineProvider } from '@mantine/core';
import { cleanup, fireEvent, render, screen } from '@testing-library/react';
import { afterEach, beforeAll, expect, it, vi } from 'vitest';
import type { NumberParam } from '../../graph/nodeType.ts';
import { msg } from '../../messages/message.ts';
import { workerServices } from '../../nodes/services.ts';
import { EditorProvider } from '../state/context.tsx';
import { createEditor, projectOfScene } from '../state/editor.ts';
import { ParamControl } from './ParamControl.tsx';

const spec: NumberParam = {
  kind: 'number',
  title: msg`Speed of light`,
  default: 30,
  min: 1,
  max: 100,
  step: 1,
  scale: 'log',
  unit: 'm/s',
};

beforeAll(() => {
  // Browser features that Mantine uses and jsdom lacks.
  vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => {}, removeEventListener: () => {} }));
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe() {}
      unobserve() {}
      disconnect() {}
    },
  );
});
afterEach(cleanup);

const editor = createEditor({ services: workerServices, project: projectOfScene(''), playing: false });

function show(set: number | undefined) {
  const onChange = vi.fn();
  render(
    <MantineProvider>
      <EditorProvider value={editor}>
        <ParamControl spec={spec} set={set} value={set ?? 30} onChange={onChange} onGestureEnd={() => {}} />
      </EditorProvider>
    </MantineProvider>,
  );
  return { onChange, field: screen.getByRole('textbox', { name: 'Speed of light' }) };
}

it('accepts input when it is committed, within the range', () => {
  const { onChange, field } = show(undefined);
  fireEvent.change(field, { target: { value: '500' } });
  expect(onChange).not.toHaveBeenCalled();
  fireEvent.keyDown(field, { key: 'Enter' });
  expect(onChange).toHaveBeenCalledWith(100);
});

it('discards input on Escape, and rejects input that is no number', () => {
  const { onChange, field } = show(undefined);
  fireEvent.change(field, { target: { value: '50' } });
  fireEvent.keyDown(field, { key: 'Escape' });
  fireEvent.blur(field);
  fireEvent.change(field, { target: { value: '' } });
  fireEvent.keyDown(field, { key: 'Enter' });
  expect(onChange).not.toHaveBeenCalled();
});

it('evaluates input as an expression with units, and reports errors', () => {
  const { onChange, field } = show(undefined);
  fireEvent.change(field, { target: { value: '2*36 km/h' } });
  fireEvent.keyDown(field, { key: 'Enter' });
  expect(onChange).toHaveBeenLastCalledWith(20);
  fireEvent.change(field, { target: { value: '40 m' } });
  fireEvent.keyDown(field, { key: 'Enter' });
  expect(field.getAttribute('aria-invalid')).toBe('true');
  fireEvent.blur(field);
  expect(field.getAttribute('value')).toBe('30 m/s');
  expect(onChange).toHaveBeenCalledTimes(1);
});

it('resets to the default', () => {
  const { onChange } = show(50);
  fireEvent.click(screen.getByRole('button', { name: 'Back to the default' }));
  expect(onChange).toHaveBeenCalledWith(undefined);
  cleanup();
  show(undefined);
  expect(screen.queryByRole('button', { name: 'Back to the default' })).toBeNull();
});

it('its slider has an accessible name and value with unit', () => {
  show(undefined);
  expect(screen.getByRole('slider', { name: 'Speed of light' }).getAttribute('aria-valuetext')).toBe('30 m/s');
});
