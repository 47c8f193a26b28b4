import { createContext, useContext } from 'react';
import { useStore } from 'zustand';
import { type LegendState, legend } from './legend.ts';
import type { Studio, StudioState } from './studio.ts';
import { type Telemetry, telemetry } from './telemetry.ts';

const StudioContext = createContext<Studio | undefined>(undefined);
export const StudioProvider = StudioContext.Provider;

export function useStudio(): Studio {
  const studio = useContext(StudioContext);
  if (!studio) throw new Error('no StudioProvider above this component');
  return studio;
}

export const useStudioState = <T,>(select: (state: StudioState) => T): T => useStore(useStudio().store, select);
export const useLegend = <T,>(select: (state: LegendState) => T): T => useStore(legend, select);
export const useTelemetry = <T,>(select: (state: Telemetry) => T): T => useStore(telemetry, select);
