// Takes npm's OpenCV.js apart: its WebAssembly, which it carries as text, and its script without dynamic code, which the
// policy of a site forbids. embind makes a function for each of C++ from text; here closures do the same.

const begin = '"data:application/octet-stream;base64,AGFzbQ';
const textStart = 'data:application/octet-stream;base64,'.length + 1;

/** embind calls these for a function of C++: arguments go into C++'s form, and the result comes back. */
const invokers = `
function invokerOf(types, isMethod, returns, invoker, target, runDestructors) {
  const [result, self, ...parameters] = types;
  const stacked = types.slice(1).some((type) => type !== null && type.destructorFunction === undefined);
  return function (...given) {
    const destructors = stacked ? [] : null;
    const wired = isMethod ? [self.toWireType(destructors, this)] : [];
    parameters.forEach((type, i) => wired.push(type.toWireType(destructors, given[i])));
    const value = invoker(target, ...wired);
    if (stacked) runDestructors(destructors);
    else (isMethod ? [self, ...parameters] : parameters).forEach((type, i) => type.destructorFunction?.(wired[i]));
    return returns ? result.fromWireType(value) : undefined;
  };
}
function methodCallerOf(types, result, kind, returnValue) {
  return (object, callee, destructors, at) => {
    let offset = 0;
    const values = types.map((type) => {
      const value = type.readValueFromPointer(at + offset);
      offset += type.argPackAdvance;
      return value;
    });
    const value = kind === 1 ? new callee(...values) : callee.call(object, ...values);
    return result.isVoid ? undefined : returnValue(result, destructors, value);
  };
}
`;

function between(text, first, last) {
  const from = text.indexOf(first);
  const to = text.indexOf(last, from);
  if (from < 0 || to < 0 || text.indexOf(first, from + 1) >= 0) throw new Error('OpenCV.js is not as it was: ' + first);
  return [from, to];
}

function replaced(text, first, last, by) {
  const [from, to] = between(text, first, last);
  return text.slice(0, from) + by + text.slice(to);
}

/** The WebAssembly, and the script without it. */
export function embeddedWasm(script) {
  const [from] = between(script, begin, '"');
  const text = from + textStart;
  const end = script.indexOf('"', text);
  return { wasm: Buffer.from(script.slice(text, end), 'base64'), script: script.slice(0, text) + script.slice(end) };
}

/** The script of OpenCV.js as a module that makes no code from text. */
export function staticScript(source) {
  let { script } = embeddedWasm(source);
  script = replaced(script, 'let[args,invokerFnBody]=createJsInvoker(', 'return createNamedFunction(humanName,invokerFn)',
    'var invokerFn=invokerOf(argTypes,isClassMethodFunc,returns,cppInvokerFunc,cppTargetFunc,runDestructors);');
  script = replaced(script, 'var functionBody=`return function (obj, func, destructorsRef, args)', 'var functionName=`methodCaller<(',
    'var invokerFunction=methodCallerOf(types,retType,kind,emval_returnValue);');
  // The functions that made code, and are not called any more.
  script = replaced(script, 'function newFunc(', 'function createJsInvoker(', '');
  script = replaced(script, 'function createJsInvoker(', 'function craftInvokerFunction(', '');
  if (/\bFunction\(|newFunc\(|\beval\(/.test(script)) throw new Error('OpenCV.js still makes code from text');
  return script + invokers;
}
