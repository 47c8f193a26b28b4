import { createContext, useContext } from 'react';
import { useStore } from 'zustand';
import { type LegendState, legendStore } from '../viewport/legend/legendState.ts';
import type { Editor, EditorState } from './editor.ts';
import { type Telemetry, telemetry } from './telemetry.ts';

const EditorContext = createContext<Editor | undefined>(undefined);
export const EditorProvider = EditorContext.Provider;

export function useEditor(): Editor {
  const editor = useContext(EditorContext);
  if (!editor) throw new Error('no StudioProvider above this component');
  return editor;
}

export const useEditorState = <T,>(select: (state: EditorState) => T): T => useStore(useEditor().store, select);
export const useLegend = <T,>(select: (state: LegendState) => T): T => useStore(legendStore, select);
export const useTelemetry = <T,>(select: (state: Telemetry) => T): T => useStore(telemetry, select);
