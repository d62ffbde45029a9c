// The checks of a node or an endpoint that both links make before they create it.

import { EndpointKind, ErrorCode, maxHashLength, maxNameLength } from '../../protocol/generated/constants.ts';
import type { EndpointDescription } from './link.ts';

const encoder = new TextEncoder();

function length(text: string): number {
  return encoder.encode(text).length;
}

/** 0, or the ErrorCode of what is wrong with a node's names. */
export function checkNode(name: string, namespace: string): number {
  const named = length(name);
  return named === 0 || named > maxNameLength || length(namespace) > maxNameLength ? ErrorCode.invalidName : 0;
}

/** 0, or the ErrorCode of what is wrong with names or kind. */
export function checkDescription({ kind, name, type, hash }: EndpointDescription): number {
  const named = length(name);
  if (named === 0 || named > maxNameLength || length(type) > maxNameLength) return ErrorCode.invalidName;
  if (length(hash) > maxHashLength) return ErrorCode.invalidArgument;
  if (kind < EndpointKind.publisher || kind > EndpointKind.server) return ErrorCode.invalidArgument;
  return 0;
}
