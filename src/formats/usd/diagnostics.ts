import type { Message } from '../../messages/message.ts';
import type { Diagnostic } from '../../scene/types.ts';
import type { DiagnosticCode } from '../diagnostics/diagnosticCodes.ts';
import type { DiagnosticList } from '../diagnostics/diagnosticLog.ts';
import type { Layer } from './layer/layer.ts';

/** A layer that is read, and where its diagnostics are collected. */
export interface ReportContext {
  readonly layer: Pick<Layer, 'name'>;
  readonly diagnostics: DiagnosticList;
}

/** Adds a diagnostic about a prim, or about the layer where `path` is empty. */
export function report(
  context: ReportContext,
  severity: Diagnostic['severity'],
  code: DiagnosticCode,
  path: string,
  message: Message,
  more: Partial<Omit<Diagnostic, 'code'>> = {},
): void {
  const { name } = context.layer;
  context.diagnostics.add({ severity, code, place: path === '' ? name : `${name}<${path}>`, message, ...more }, name);
}
