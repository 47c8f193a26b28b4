import type { ReactNode } from 'react';
import type { GraphNode } from '../../graph/document/document.ts';
import { isParamActive, type NodeType, type ParamSpec, resolveParams, resolveSpec } from '../../graph/nodeType.ts';
import type { LocalizedText } from '../../messages/message.ts';
import { useTexts } from '../language/languageStore.ts';
import { useEditor, useEditorState } from '../state/context.tsx';
import { ParamControl } from './ParamControl.tsx';
import { suggestion } from './suggestion.ts';

/**
 * Parameters that are active with the current values: not the steps of a solver that is not chosen. `always`: names of
 * those displayed regardless.
 */
export function visibleParams(
  type: NodeType,
  set: GraphNode['params'],
  always: Readonly<Record<string, unknown>> = {},
): readonly (readonly [name: string, spec: ParamSpec])[] {
  const resolved = resolveParams(type, set);
  return Object.entries(type.params).flatMap(([name, spec]) =>
    always[name] || isParamActive(type, spec, resolved) ? [[name, resolveSpec(type, spec, resolved)] as const] : [],
  );
}

interface NodeParamsProps {
  /** Id in evaluation results. */
  readonly node: string;
  readonly type: NodeType;
  readonly set: GraphNode['params'];
  readonly visible: ReturnType<typeof visibleParams>;
  /** Titles of the nodes that drive parameters, by parameter. */
  readonly inputTitles: Readonly<Record<string, LocalizedText>>;
}

/** A control for each parameter. */
export function NodeParams({ node, type, set, visible: shown, inputTitles }: NodeParamsProps): ReactNode {
  const { t } = useTexts();
  const editor = useEditor();
  const picture = useEditorState((state) => state.picture);
  const resolved = resolveParams(type, set);
  return shown.map(([name, spec]) => (
    <ParamControl
      key={name}
      spec={spec}
      set={set[name]}
      value={resolved[name] ?? suggestion(spec, picture)}
      choices={picture?.scene.cameras.map(({ path }) => path)}
      drivenBy={inputTitles[name] && t(inputTitles[name])}
      onChange={(value, gesture) => editor.set(node, name, value, spec.title, gesture)}
      onGestureEnd={editor.endGesture}
    />
  ));
}
